using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests.Help;

public sealed class HelpTextTests
{
    public static TheoryData<string> Paths => new(CommandTable.All.Select(entry => entry.Path));

    [Theory]
    [MemberData(nameof(Paths))]
    public void Help_OfEachCommand_NamesItsOptionsIn80Columns(string path)
    {
        CommandLineRun run = CommandLineRun.Of([.. path.Split(' ', StringSplitOptions.RemoveEmptyEntries), "--help"]);
        string[] lines = run.Output.Split('\n');
        CommandSpec command = CommandTable.All.Single(entry => entry.Path == path).Command;

        Assert.Equal(0, run.ExitCode);
        Assert.All(lines, line => Assert.True(line.Length < 80, $"{line.Length} columns: {line}"));
        Assert.All(command.Options, option =>
        {
            string call = (option.Aliases.Count == 0 ? "      " : "  ") + string.Join(", ", option.Aliases.Append(option.Name));
            Assert.Single(lines, line => line == call || line.StartsWith($"{call} ", StringComparison.Ordinal));
        });
    }

    [Fact]
    public void Help_OfARun_BeginsWithTheCameraAndEndsWithTheCommands()
    {
        string[] lines = CommandLineRun.Of(["--help"]).Output.Split('\n');
        string[] titles =
        [
            "Examples:", "Where the camera is:", "Image:", "Light:", "Surface model:", "Albedo:", "Output:", "Renderer:",
            "Native renderer:",
            "Truth for navigation:",
            "POV-Ray:", "Run:", "Commands:",
        ];

        Assert.Equal(titles, lines.Where(line => line.Length > 0 && line[0] != ' ' && line.EndsWith(':')));
    }

    [Fact]
    public void Help_HeightIsNotHelp_AndDefaultsStandOnce()
    {
        string help = CommandLineRun.Of(["-?"]).Output;

        Assert.Contains("-h, --height PX", help, StringComparison.Ordinal);
        Assert.All(
            CommandTable.Render.Options,
            option => Assert.DoesNotContain("default", option.Help, StringComparison.OrdinalIgnoreCase));
    }

    [Theory]
    [InlineData("help", "--help")]
    [InlineData("-h", "--help")]
    [InlineData("help ldem", "ldem --help")]
    [InlineData("help ldem pyramid", "ldem pyramid --help")]
    [InlineData("help help", "help --help")]
    [InlineData("status -h", "status --help")]
    [InlineData("patterns -h", "patterns --help")]
    [InlineData("ldem pyramid -h", "ldem pyramid --help")]
    public void Help_AskedForInOtherWords_IsTheSame(string words, string other)
    {
        CommandLineRun run = CommandLineRun.Of(words.Split(' '));

        Assert.Equal(0, run.ExitCode);
        Assert.Equal(CommandLineRun.Of(other.Split(' ')).Output, run.Output);
    }

    [Fact]
    public void Help_OfAMisspeltCommand_NamesTheNearest()
    {
        CommandLineRun run = CommandLineRun.Of(["help", "pyramd"]);

        Assert.Equal(1, run.ExitCode);
        Assert.Equal("msis: error: 'pyramd' is no command: did you mean pyramid? msis help lists them.\n", run.Error);
    }

    [Fact]
    public void Help_HeightWithANumber_StaysTheHeight() =>
        Assert.Contains("nothing says where the camera is", CommandLineRun.Of(["-h", "5"]).Error, StringComparison.Ordinal);

    [Fact]
    public void ManualPage_NamesEachOptionOfEachCommand()
    {
        string page = CommandLineRun.Of(["man"]).Output.Replace("\\-", "-", StringComparison.Ordinal);

        Assert.All(
            CommandTable.All.SelectMany(entry => entry.Command.Options),
            option => Assert.Contains($"{option.Name}", page, StringComparison.Ordinal));
        Assert.All(
            page.Split('\n').Where(line => line.StartsWith('.')),
            line => Assert.Matches(@"^\.(TH|SH|SS|B|TP|PP|br|nf|fi|RS|RE)\b", line));
    }
}
