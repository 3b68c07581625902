using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Programs;

namespace Msisf.Benchmarks.Measures;

/// <summary>One frame by a process of its own, all files written: by the native renderer, and by POV-Ray's way in turn with it.</summary>
internal sealed class FirstFrames
{
    private readonly Workbench _bench;
    private readonly Repeats _repeats;

    public FirstFrames(Workbench bench, Repeats repeats)
    {
        _bench = bench;
        _repeats = repeats;
    }

    /// <summary>Measures a scene; POV-Ray's patterns are there already.</summary>
    public FirstFrameResult Measure(Scene scene)
    {
        List<ProgramRun> native = [];
        List<double> povRay = [];
        List<double> povRayPlain = [];
        int povRayRuns = scene.PovRay switch
        {
            PovRayUse.Repeatedly => _repeats.PovRayPictures,
            PovRayUse.Once => 1,
            _ => 0,
        };
        for (int run = 0; run < Math.Max(_repeats.FirstFrames, povRayRuns); run++)
        {
            if (run < _repeats.FirstFrames)
            {
                native.Add(Run(scene, ["--renderer", "native", .. scene.IsExact ? (string[])["--lod", "off"] : []]));
            }

            if (run < povRayRuns)
            {
                povRay.Add(PovRay(scene).Seconds);
                if (scene.PovRay == PovRayUse.Repeatedly)
                {
                    povRayPlain.Add(PovRay(scene, "--pov-options", "Antialias=Off").Seconds);
                }
            }
        }

        return new FirstFrameResult(native, SamplesOf(povRay), SamplesOf(povRayPlain));
    }

    private static Samples? SamplesOf(List<double> values) => values.Count == 0 ? null : new Samples(values);

    private ProgramRun PovRay(Scene scene, params string[] options) =>
        Run(scene, ["--renderer", "povray", "--pattern-repos", _bench.Patterns, .. options]);

    private ProgramRun Run(Scene scene, IReadOnlyList<string> options) => _bench.Msis.Run(
    [
        "--fixed-state", scene.FixedState,
        .. _bench.PictureOptions(scene.PixelsPerDegree, _bench.NewOutputFolder()),
        .. options,
    ]);
}
