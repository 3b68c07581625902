using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Programs;

namespace Msisf.Benchmarks.Measures;

/// <summary>What processes of one frame cost.</summary>
/// <param name="Native">The native renderer's runs.</param>
/// <param name="PovRay">s; POV-Ray's way, with patterns in place and POV-Ray's usual antialiasing; null if not measured.</param>
/// <param name="PovRayWithoutAntialiasing">s; null if not measured.</param>
internal sealed record FirstFrameResult(IReadOnlyList<ProgramRun> Native, Samples? PovRay, Samples? PovRayWithoutAntialiasing)
{
    private RunTiming[] Timings { get; } = [.. Native.Select(RunTiming.Of)];

    public Samples Seconds => new(Native.Select(run => run.Seconds));

    public Samples PeakMemoryBytes => new(Timings.Select(timing => timing.PeakMemoryBytes));

    /// <summary>s, each phase that took any time in a run.</summary>
    public IEnumerable<(string Phase, Samples Seconds)> Phases =>
        from timing in Timings
        from phase in timing.Phases
        group phase.Seconds by phase.Phase into phase
        select (phase.Key, new Samples(phase));
}
