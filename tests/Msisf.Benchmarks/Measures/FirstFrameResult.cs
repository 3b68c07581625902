using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Programs;

namespace Msisf.Benchmarks.Measures;

/// <summary>What processes of one frame by the native renderer cost.</summary>
/// <param name="Runs">The processes.</param>
internal sealed record FirstFrameResult(IReadOnlyList<ProgramRun> Runs)
{
    private RunTiming[] Timings { get; } = [.. Runs.Select(RunTiming.Of)];

    public Samples Seconds => new(Runs.Select(run => run.Seconds));

    public Samples PeakMemoryBytes => new(Timings.Select(timing => timing.PeakMemoryBytes));

    /// <summary>s, each phase that took any time in a run.</summary>
    public IEnumerable<(string Phase, Samples Seconds)> Phases =>
        from timing in Timings
        from phase in timing.Phases
        group phase.Seconds by phase.Phase into phase
        select (phase.Key, new Samples(phase));
}
