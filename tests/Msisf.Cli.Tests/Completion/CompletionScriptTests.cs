using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests.Completion;

public sealed class CompletionScriptTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("bash")]
    [InlineData("zsh")]
    [InlineData("fish")]
    public void Script_HasEachOptionAndChoice(string shell)
    {
        string script = Script(shell);

        Assert.All(
            CommandTable.All.SelectMany(entry => entry.Command.Options).DistinctBy(option => option.Name),
            option =>
            {
                // fish takes the names without their dashes
                Assert.Contains(shell == "fish" ? option.Key : option.Name, script, StringComparison.Ordinal);
                Assert.All(option.Suggestions, word => Assert.Contains(word, script, StringComparison.Ordinal));
            });
    }

    [Theory]
    [InlineData("msis --rend", "--renderer --rendering-annotation")]
    [InlineData("msis --renderer ", "povray native")]
    [InlineData("msis --renderer na", "native")]
    [InlineData("msis --layers depth,no", "depth,normal")]
    [InlineData("msis ver", "verify")]
    [InlineData("msis ldem ", "synthesize pyramid")]
    [InlineData("msis ldem synthesize --se", "--seed")]
    [InlineData("msis completion z", "zsh")]
    public void Bash_CompletesAsATypistExpects(string line, string expected)
    {
        string script = Path.Combine(_folder.Path, "completion.bash");
        File.WriteAllText(script, Script("bash"));
        const string Complete = """
            source "$1"
            read -ra COMP_WORDS <<<"$2"
            [[ $2 != *' ' ]] || COMP_WORDS+=('')
            COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
            _msis
            echo "${COMPREPLY[*]}"
            """;
        ChildRun run = ChildRun.Of("bash", ["-c", Complete, "bash", script, line], _folder.Path).Succeeded();

        Assert.Equal(
            expected.Split(' ').Order(StringComparer.Ordinal), run.Output.Trim().Split(' ').Order(StringComparer.Ordinal));
    }

    [Fact]
    public void Script_OfAnotherShell_IsRefusedWithThoseThereAre()
    {
        CommandLineRun run = CommandLineRun.Of(["completion", "tcsh"]);

        Assert.Equal(1, run.ExitCode);
        Assert.Contains("bash, zsh, fish", run.Error, StringComparison.Ordinal);
    }

    private static string Script(string shell) => CommandLineRun.Of(["completion", shell]).Output;
}
