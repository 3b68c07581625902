using System.Text.Json;
using Msisf.TestSupport;

namespace Msisf.Stress.Cluster;

/// <summary>Many processes at once in one empty folder, with one empty pattern repository.</summary>
public sealed class CrowdStress : IStressTest
{
    private const string Output = "frames";
    private const string Patterns = "patterns";

    /// <inheritdoc/>
    public string Name => "crowd";

    /// <inheritdoc/>
    public string Subject =>
        "16 processes (8 at everyday length) started at once, each for all frames, into one empty folder: "
            + "by the native renderer, and by POV-Ray with one empty pattern repository.";

    /// <inheritdoc/>
    public string? MissingPart => Msis.MissingPart ?? (TestParts.Program("povray") is null ? "POV-Ray" : null);

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        (int processes, int native, int povRay) = length == StressLength.Full ? (16, 5000, 64) : (8, 120, 3);
        SetJudge judge = new();
        CaseCount patterns = new();
        Crowd(processes, new FrameSeries(native, Size: 64), "native", judge, patterns);
        Crowd(processes, new FrameSeries(povRay, Size: 32, Patterns), "POV-Ray", judge, patterns);
        return new StressReport(
            Name, native + povRay, [.. judge.Figures(), patterns.ToFigure("patterns made more than once", string.Empty, 0.0)], []);
    }

    private static void Crowd(int processes, FrameSeries series, string what, SetJudge judge, CaseCount patterns)
    {
        using TemporaryFolder alone = new();
        using TemporaryFolder folder = new();
        int made = PatternsMade(Msis.Run(alone.Path, Arguments(series)).Succeeded());

        RunningProgram[] crowd = [.. Enumerable.Range(0, processes).Select(_ => Msis.Start(folder.Path, Arguments(series)))];
        try
        {
            ChildRun[] runs = [.. crowd.Select(program => program.End(Msis.Limit))];
            foreach (ChildRun run in runs)
            {
                judge.NoteRun(run, what);
            }

            judge.Judge(new FrameFolder(folder[Output]), new FrameFolder(alone[Output]), runs[^1], inFlight: 0, what);
            if (series.Patterns is not null)
            {
                string model = Path.Combine(Patterns, "LDEM_4");
                FrameFolder patternsMade = new(folder[model]);
                judge.NoteDifferences(patternsMade, new FrameFolder(alone[model]), what);
                judge.NoteLeftovers(patternsMade.Leftovers, what);
                int all = runs.Sum(PatternsMade);
                patterns.Note(Math.Max(0, all - made), made, () => $"{all} made by {processes} processes, {made} by one");
            }
        }
        finally
        {
            Array.ForEach(crowd, program => program.Dispose());
        }
    }

    private static IReadOnlyList<string> Arguments(FrameSeries series) => series.Arguments(Output, "--jobs", "1", "--timing");

    /// <summary>As the line of --timing has it.</summary>
    private static int PatternsMade(ChildRun run)
    {
        string? times = run.Error.Split('\n').LastOrDefault(line => line.StartsWith('{'));
        return times is null ? 0 : JsonDocument.Parse(times).RootElement.GetProperty("patterns_made").GetInt32();
    }
}
