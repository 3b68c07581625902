using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Cli.Help;
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
        CommandLineRun run = CommandLineRun.Of([.. path.Split(' ', StringSplitOptions.RemoveEmptyEntries), "--help", "all"]);
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

    /// <summary>The first page fits on a screen, and says where the rest is.</summary>
    [Theory]
    [InlineData("", "msis help TOPIC")]
    [InlineData("batchconvert", "msis batchconvert --help all")]
    [InlineData("submit", "msis submit --help all")]
    [InlineData("states", "msis states --help all")]
    public void Help_FirstPage_HasAtMost60LinesOf80Columns(string path, string rest)
    {
        string page = CommandLineRun.Of([.. path.Split(' ', StringSplitOptions.RemoveEmptyEntries), "--help"]).Output;
        string[] lines = page.TrimEnd().Split('\n');

        Assert.InRange(lines.Length, 15, 60);
        Assert.All(lines, line => Assert.True(line.Length < 80, $"{line.Length} columns: {line}"));
        Assert.Contains(rest, page.Replace("\n", " ", StringComparison.Ordinal), StringComparison.Ordinal);
    }

    /// <summary>Each option of the first page is one of a run; each topic has options, and together they have nearly all.</summary>
    [Fact]
    public void Help_Topics_HaveTheOptionsOfARun()
    {
        string pages = string.Concat(ShortHelp.Topics.Keys.Select(topic => CommandLineRun.Of(["help", topic]).Output));

        Assert.All(
            CommandTable.OptionsOfRun,
            option => Assert.Contains($"{option.Name} ", $"{pages.ReplaceLineEndings(" ")} ", StringComparison.Ordinal));
        Assert.InRange(ShortHelp.Tasks.Sum(task => task.Options.Count), 20, 30);
        Assert.All(
            ShortHelp.Tasks.SelectMany(task => task.Options), option => Assert.Contains(option.Option, CommandTable.Render.Options));
    }

    [RequiresFact(Part.Ldem4)]
    public void Help_Examples_Run()
    {
        using TemporaryFolder folder = new();
        string batch = folder.Write("approach.tab", "55289 2E6 2E6 0 0 0 0 1\n55290 2E6 2E6 0 0 0 0 1\n");
        Assert.Equal(6, CommandTable.Render.Examples.Count);
        Assert.All(CommandTable.Render.Examples, example =>
        {
            List<string> words = [.. example.Call.Replace("'", string.Empty, StringComparison.Ordinal).Split(' ').Skip(1)
                .Select(word => word == "approach.tab" ? batch : word)];
            string[] more = words[0] == "places" ? []
                : words[0] == "batchconvert" ? ["--script", folder["pieces.sh"]]
                : ["--width", "32", "--height", "24", "--output-dir", folder["out"], "--overwrite"];
            CommandLineRun run = CommandLineRun.Of([.. words, .. more]);
            Assert.True(run.ExitCode == 0, $"{example.Call}: {run.Error}");
            Assert.NotEmpty(run.Output);
        });
    }

    [Fact]
    public void Help_OfARun_BeginsWithTheCameraAndEndsWithTheCommands()
    {
        string[] lines = CommandLineRun.Of(["--help", "all"]).Output.Split('\n');
        string[] titles =
        [
            "Examples:", "Where the camera is:", "Image:", "Light:", "Surface model:", "Albedo:", "Output:", "Renderer:",
            "Native renderer:",
            "Truth for navigation:", "Sky:",
            "POV-Ray:", "Run:", "Commands:",
        ];

        Assert.Equal(titles, lines.Where(line => line.Length > 0 && line[0] != ' ' && line.EndsWith(':')));
    }

    [Fact]
    public void Help_HeightIsNotHelp_AndDefaultsStandOnce()
    {
        string help = CommandLineRun.Of(["help", "all"]).Output;

        Assert.Contains("-h, --height PX", help, StringComparison.Ordinal);
        Assert.All(
            CommandTable.Render.Options,
            option => Assert.DoesNotContain("default", option.Help, StringComparison.OrdinalIgnoreCase));
    }

    [Theory]
    [InlineData("help", "--help")]
    [InlineData("help", "-?")]
    [InlineData("help all", "--help all")]
    [InlineData("help camera", "--help camera")]
    [InlineData("help batchconvert all", "batchconvert --help all")]
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
        Assert.Equal("msis: error: 'pyramd' is neither a command nor a topic: did you mean pyramid? msis help lists them.\n", run.Error);
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
