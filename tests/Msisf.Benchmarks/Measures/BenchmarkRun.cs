using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Programs;

namespace Msisf.Benchmarks.Measures;

/// <summary>Measures what was asked for, one thing after another.</summary>
internal static class BenchmarkRun
{
    public static BenchmarkResult Measure(BenchmarkOptions options, TextWriter log)
    {
        Workbench bench = new(options.Root, options.Folder, options.Models);
        using Sun sun = Sun.Open(bench.Root);
        string loadBefore = Machine.Load();
        List<SceneResult> scenes = [];
        foreach (Scene scene in options.Chosen)
        {
            log.WriteLine($"{scene.Name}: {scene.About}");
            int? patterns = scene.PovRay == PovRayUse.No ? null : PatternMaker.Make(scene, bench, sun.Ephemeris);
            FirstFrameResult first = new FirstFrames(bench, options.Repeats).Measure(scene);
            scenes.Add(new SceneResult(scene, patterns, first, new FurtherFrames(bench, options.Repeats).Measure(scene)));
        }

        Sequences sequences = new(bench, options.Repeats);
        SequenceResult? plain = null;
        SequenceResult? layered = null;
        if (options.HasSequence)
        {
            log.WriteLine(FormattableString.Invariant($"sequence: {options.Repeats.SequenceFrames} frames"));
            plain = sequences.Plain();
            log.WriteLine(FormattableString.Invariant($"sequence: {options.Repeats.LayeredFrames} frames with all layers"));
            layered = sequences.WithLayers();
        }

        string machine = $"{Machine.Describe()} Load before and after the run: {loadBefore} and {Machine.Load()}.";
        return new BenchmarkResult(machine, scenes, plain, layered);
    }
}
