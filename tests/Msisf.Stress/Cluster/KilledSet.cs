using System.Diagnostics;
using Msisf.TestSupport;

namespace Msisf.Stress.Cluster;

/// <summary>
/// A set of frames that is made again and again in one folder each by runs that are killed, until a last run may finish it.
/// </summary>
internal sealed class KilledSet : IDisposable
{
    private const string Output = "frames";
    private const string Patterns = "patterns";
    private const string PovRay = "povray";

    /// <summary>Frames at once; as many may be lost in flight by one kill.</summary>
    private const int Jobs = 2;

    private static readonly TimeSpan Orphans = TimeSpan.FromSeconds(20);

    private readonly TemporaryFolder _undisturbedFolder = new();
    private readonly FrameSeries _series;
    private readonly double _seconds;

    /// <summary>Makes the frames once undisturbed.</summary>
    public KilledSet(int frames, int size, bool isPovRay)
    {
        _series = new FrameSeries(frames, size, isPovRay ? Patterns : null);
        Stopwatch watch = Stopwatch.StartNew();
        Msis.Run(_undisturbedFolder.Path, Arguments).Succeeded();
        _seconds = watch.Elapsed.TotalSeconds;
    }

    private IReadOnlyList<string> Arguments => _series.Arguments(Output, "--jobs", $"{Jobs}");

    /// <summary>Kills runs in a fresh folder, finishes the set and judges it.</summary>
    /// <param name="kills">How many at most; fewer if the set is finished before.</param>
    /// <param name="isPovRayKilled">POV-Ray instead of the program itself.</param>
    /// <returns>How many there were.</returns>
    public int Run(int kills, bool isPovRayKilled, CaseRandom random, SetJudge judge, CaseCount unnoticed, string what)
    {
        using TemporaryFolder folder = new();
        int done = 0;
        bool isFinished = false;
        while (done < kills && !isFinished)
        {
            using RunningProgram program = Msis.Start(folder.Path, Arguments);
            int killed = isPovRayKilled ? KillPovRay(program, kills - done, random, unnoticed, what) : KillProgram(program, random);
            isFinished = killed == 0;
            done += killed;
        }

        // A POV-Ray without its msis may put its image into a work folder just as a run removes it, which the next run makes good.
        judge.NoteLeftovers(Processes(folder.Path), what);
        ChildRun last = Msis.Run(folder.Path, Arguments);
        FrameFolder set = new(folder[Output]);
        judge.Judge(set, new FrameFolder(_undisturbedFolder[Output]), last, done * Jobs, what);
        if (_series.Patterns is not null)
        {
            FrameFolder patterns = new(folder[Path.Combine(Patterns, "LDEM_4")]);
            judge.NoteDifferences(patterns, new FrameFolder(_undisturbedFolder[Path.Combine(Patterns, "LDEM_4")]), what);
            judge.NoteLeftovers(patterns.Leftovers, what);
        }

        return done;
    }

    public void Dispose() => _undisturbedFolder.Dispose();

    /// <summary>At any moment of a run, its start and end too.</summary>
    private int KillProgram(RunningProgram program, CaseRandom random)
    {
        if (program.EndsWithin(TimeSpan.FromSeconds(random.Unit() * _seconds)))
        {
            return 0;
        }

        program.Kill();
        return program.End(Msis.Limit).ExitCode == 0 ? 0 : 1;
    }

    /// <summary>Several in one run, which goes on with its other frames and has to say what failed.</summary>
    private int KillPovRay(RunningProgram program, int most, CaseRandom random, CaseCount unnoticed, string what)
    {
        int killed = 0;
        while (killed < most && !program.EndsWithin(TimeSpan.FromSeconds(random.Unit() * _seconds / 2)))
        {
            // A POV-Ray that is asked for its version may be killed after it has answered, which nobody has to notice.
            int[] running =
                [.. ProcessTable.ChildrenOf(program.Id, PovRay).Where(id => !ProcessTable.ArgumentsOf(id).Contains("--version"))];
            killed += running.Length > 0 && ProcessTable.KillAtWork(running[random.Below(running.Length)]) ? 1 : 0;
        }

        ChildRun run = program.End(Msis.Limit);
        if (killed > 0)
        {
            unnoticed.Note(run.ExitCode != 3, () => $"{what}: exit code {run.ExitCode}: {SetJudge.OneLine(run.Error)}");
        }

        return killed;
    }

    /// <summary>POV-Rays whose msis was killed end with their image.</summary>
    private static IReadOnlyList<string> Processes(string folder)
    {
        Stopwatch watch = Stopwatch.StartNew();
        IReadOnlyList<int> left = ProcessTable.Below(folder);
        while (left.Count > 0 && watch.Elapsed < Orphans)
        {
            Thread.Sleep(100);
            left = ProcessTable.Below(folder);
        }

        return [.. left.Select(id => $"process {id} ({ProcessTable.NameOf(id)})")];
    }
}
