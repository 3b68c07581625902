using System.Globalization;
using System.Text.RegularExpressions;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary><c>msis patterns</c>: ahead of a run, and by several processes on one repository.</summary>
public sealed class PatternRunTests : IDisposable
{
    private const int AllPatterns = 2592;

    /// <summary>The whole Moon from afar, where coarser levels are drawn.</summary>
    private const string Far = "55289 7E6 7E6 0 0 0 3.826834323650898E-1 9.238795325112867E-1\n";

    private const string Near = """
        55289 2E6 2E6 0 0 0 3.826834323650898E-1 9.238795325112867E-1
        55289 2E6 -2E6 0 0 0 -3.826834323650898E-1 9.238795325112867E-1
        55289 2E6 2E6 1E6 0 0 3.826834323650898E-1 9.238795325112867E-1
        """;

    /// <summary>Blocks of 16 x 16 cells of LDEM_4, whose mesh has 722 lines of vertices and 1440 columns of cells.</summary>
    private const int AllBlocks = 46 * 90;

    private static readonly string[] Kepler =
        ["--kepler-set", "{1.9E6,0,0,0,1.2,0}", "--epoch", "55289", "--times", "{55289,55289.01,55289.02}", "--fov", "30"];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    private string[] Sources =>
        ["--ldem", TestParts.Ldem4Label!, "--pattern-repos", _folder["patterns"], "--ephemeris", "builtin", "--batch"];

    [RequiresTheory(Part.Ldem4, Part.PovRay)]
    [InlineData("auto", Far + Near)]
    [InlineData("off", Near)]
    public void ForBatch_ThenTheRun_FindsAllPatterns(string levels, string states)
    {
        string batch = _folder.Write("states.tab", states);
        string[] image = ["--width", "48", "--height", "32", "--lod", levels, .. Sources];

        int made = Made(Msis(["patterns", "--for-batch", batch, .. image]));
        CommandLineRun run = Msis(["--batch-file", batch, "--timing", "--output-dir", _folder["out"], .. image]);

        Assert.InRange(made, 1, (levels == "off" ? AllPatterns : AllBlocks) - 1);
        Assert.Contains("\"patterns_made\":0,", run.Error, StringComparison.Ordinal);
        Assert.Equal(0, Made(Msis(["patterns", "--for-batch", batch, .. image])));
    }

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void ForBatch_SomeFramesOfAnOrbit_AreMadeForThese()
    {
        string[] image = ["--width", "48", "--height", "32", .. Sources];
        string[] render = [.. Kepler, "--timing", "--output-dir", _folder["out"], .. image];

        Assert.InRange(Made(Msis(["patterns", .. Kepler, "--frames", "2:3", .. image])), 1, AllPatterns - 1);
        Assert.Contains("\"patterns_made\":0,", Msis([.. render, "--frames", "2:3"]).Error, StringComparison.Ordinal);
        Assert.DoesNotContain("\"patterns_made\":0,", Msis(render).Error, StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4)]
    public async Task Patterns_FourProcessesAtOnce_MakeEachOnce()
    {
        ChildRun[] runs = await Within.Seconds(600, "four processes at once", Task.WhenAll(Enumerable.Range(0, 4).Select(_ => Task.Run(
            () => ChildRun.Of(TestedProgram.File, TestedProgram.Words(PatternsOfTheMoon), _folder.Path).Succeeded()))));

        Assert.Equal(AllPatterns, runs.Sum(run => Made(run.Error)));
        Assert.Equal(AllPatterns, Directory.GetFiles(Path.Combine(_folder["patterns"], "4"), "pattern_*").Length);
    }

    [RequiresFact(Part.Ldem4)]
    public async Task Patterns_KilledAtWork_AreFinishedByTheNext()
    {
        string patterns = Directory.CreateDirectory(Path.Combine(_folder["patterns"], "4")).FullName;
        IEnumerable<string> made = Directory.EnumerateFiles(patterns, "pattern_*").Where(
            path => !path.Contains(".partial", StringComparison.Ordinal));
        using RunningProgram killed = RunningProgram.Start(TestedProgram.File, TestedProgram.Words(PatternsOfTheMoon), _folder.Path);
        await Within.Seconds(120, "the first pattern of the process that is to be killed", made.Any);
        killed.Kill();
        killed.End(TimeSpan.FromSeconds(30));
        int finished = made.Count();

        CommandLineRun next = Msis(PatternsOfTheMoon);

        Assert.InRange(finished, 1, AllPatterns - 1);
        Assert.Equal(AllPatterns - finished, Made(next));
    }

    private string[] PatternsOfTheMoon =>
        ["patterns", "--ldem", TestParts.Ldem4Label!, "--pattern-repos", _folder["patterns"], "--batch"];

    private static CommandLineRun Msis(string[] arguments)
    {
        CommandLineRun run = CommandLineRun.Of(arguments);
        Assert.True(run.ExitCode == 0, run.Error);
        return run;
    }

    private static int Made(CommandLineRun run) => Made(run.Error);

    private static int Made(string notes) =>
        int.Parse(Regex.Match(notes, @"(\d+) of \d+ patterns made").Groups[1].Value, CultureInfo.InvariantCulture);
}
