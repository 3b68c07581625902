using System.Diagnostics;
using System.Globalization;
using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Fronts;
using Msisf.Benchmarks.Programs;

namespace Msisf.Benchmarks.Measures;

/// <summary>Measures what was asked for, one thing after another.</summary>
internal sealed class BenchmarkRun
{
    private readonly BenchmarkOptions _options;
    private readonly Workbench _bench;
    private readonly TextWriter _log;
    private readonly long _start = Stopwatch.GetTimestamp();

    private BenchmarkRun(BenchmarkOptions options, TextWriter log)
    {
        _options = options;
        _bench = new Workbench(options.Root, options.Folder, options.Models);
        _log = log;
    }

    /// <summary>Measures.</summary>
    /// <param name="options">What.</param>
    /// <param name="log">Is told what is being measured.</param>
    public static BenchmarkResult Measure(BenchmarkOptions options, TextWriter log) => new BenchmarkRun(options, log).Measure();

    private BenchmarkResult Measure()
    {
        string loadBefore = Machine.Load();
        IReadOnlyList<SceneFront> fronts = Fronts();
        FromNothingResult? fromNothing = null;
        if (_options.HasFromNothing)
        {
            Say("the first image from nothing but the model");
            fromNothing = FromNothing.Measure(_bench);
        }

        IReadOnlyList<SceneResult> scenes = NativeFrames();
        (SequenceResult? plain, SequenceResult? layered) = _options.HasSequence ? Sequence() : default;
        SequenceResult? descent = null;
        if (_options.HasDescent)
        {
            Say(FormattableString.Invariant($"descent: {_options.Repeats.DescentFrames} frames"));
            descent = new Descent(_bench).Run(_options.Repeats.DescentFrames);
        }

        DetectorResult? detector = null;
        if (_options.HasDetector)
        {
            Say("the detector");
            detector = DetectorResult.Measure(_options.Repeats);
        }

        string machine = string.Create(
            CultureInfo.InvariantCulture,
            $"{Machine.Describe()} Load before and after the run: {loadBefore} and {Machine.Load()}. "
                + $"The run took {Stopwatch.GetElapsedTime(_start).TotalMinutes:F1} minutes.");
        return new BenchmarkResult(machine, scenes, fronts, fromNothing, plain, layered, descent, detector);
    }

    private List<SceneFront> Fronts()
    {
        using Sun sun = Sun.Open(_bench.Root);
        FrontMeasure measure = new(_bench, sun.Ephemeris, _options.Repeats.Images, _log);
        List<SceneFront> fronts = [];
        foreach (Scene scene in _options.Chosen.Where(scene => scene.Settings.Count > 0))
        {
            Say($"{scene.Name}, time against error: {scene.About}");
            fronts.Add(measure.Measure(scene));
        }

        return fronts;
    }

    private List<SceneResult> NativeFrames()
    {
        List<SceneResult> results = [];
        foreach (Scene scene in _options.Chosen)
        {
            if (scene.Targets is SceneTargets targets)
            {
                Say($"{scene.Name}, native frames: {scene.About}");
                FirstFrameResult first = new FirstFrames(_bench, _options.Repeats).Measure(scene);
                IReadOnlyList<FurtherFramesResult> further = new FurtherFrames(_bench, _options.Repeats).Measure(scene);
                IReadOnlyList<SampledFramesResult> sampled = targets.Sampled is { } sampledTarget
                    ? new SampledFrames(_bench, _options.Repeats).Measure(scene, sampledTarget)
                    : [];
                results.Add(new SceneResult(scene, targets, first, further, sampled));
            }
        }

        return results;
    }

    private (SequenceResult Plain, SequenceResult Layered) Sequence()
    {
        Sequences sequences = new(_bench, _options.Repeats);
        Say(FormattableString.Invariant($"sequence: {_options.Repeats.SequenceFrames} frames"));
        SequenceResult plain = sequences.Plain();
        Say(FormattableString.Invariant($"sequence: {_options.Repeats.LayeredFrames} frames with all layers"));
        return (plain, sequences.WithLayers());
    }

    private void Say(string what) =>
        _log.WriteLine(FormattableString.Invariant($"{Stopwatch.GetElapsedTime(_start).TotalSeconds,6:F0} s  {what}"));
}
