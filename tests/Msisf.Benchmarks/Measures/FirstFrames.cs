using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Programs;

namespace Msisf.Benchmarks.Measures;

/// <summary>One frame by the native renderer, in a process of its own, all files written.</summary>
internal sealed class FirstFrames
{
    private readonly Workbench _bench;
    private readonly Repeats _repeats;

    public FirstFrames(Workbench bench, Repeats repeats)
    {
        _bench = bench;
        _repeats = repeats;
    }

    /// <summary>Measures a scene.</summary>
    public FirstFrameResult Measure(Scene scene) => new([.. Enumerable.Range(0, _repeats.FirstFrames).Select(_ => Run(scene))]);

    private ProgramRun Run(Scene scene) => _bench.Msis.Run(
    [
        "--fixed-state", scene.FixedState,
        .. _bench.ImageOptions(scene.Model, _bench.NewOutputFolder(), scene.Side),
        "--renderer", "native", "--reflectance", "lambert",
        .. scene.IsExact ? (string[])["--lod", "off"] : [],
    ]);
}
