using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Measures;

namespace Msisf.Benchmarks.Reports;

/// <summary>Compares what was measured with the targets. Times count by their median, memory by its maximum.</summary>
internal static class Verdicts
{
    public static IEnumerable<Verdict> Of(BenchmarkResult result) =>
        [
            .. FrontVerdicts.Of(result), .. result.Scenes.SelectMany(scene => Of(scene, result)),
            .. OfSequence(result.Sequence, "orbit", SequenceTargets.FramesPerSecond, isAlike: true),
            .. OfLayers(result.Layers),
            .. OfSequence(result.Descent, "descent", SequenceTargets.DescentFramesPerSecond, isAlike: false),
            .. OfDetector(result.Detector),
        ];

    private static IEnumerable<Verdict> Of(SceneResult result, BenchmarkResult all)
    {
        Scene scene = result.Scene;
        Samples first = result.First.Seconds;
        Samples further = result.DefaultFurtherSeconds;
        Samples memory = result.First.PeakMemoryBytes;
        yield return new Verdict(
            scene.About, "first frame, from process start", result.Targets.FirstSeconds, IsUpperLimit: true, first.Median, first.Minimum,
            Unit.Milliseconds);
        yield return new Verdict(
            scene.About, "further frames", result.Targets.FurtherSeconds, IsUpperLimit: true, further.Median, further.Minimum,
            Unit.Milliseconds);
        yield return new Verdict(
            scene.About, "memory", result.Targets.MemoryBytes, IsUpperLimit: true, memory.Maximum, memory.Minimum, Unit.Megabytes);
        if (result.Targets.Sampled is { } target && result.Sampled.FirstOrDefault(way => way.Samples == target.Samples) is { } sampled)
        {
            Samples seconds = new(sampled.FrameSeconds);
            yield return new Verdict(
                scene.About, $"further frames, --samples {target.Samples}", target.Seconds, IsUpperLimit: true, seconds.Median,
                seconds.Minimum, Unit.Milliseconds);
            double even = result.Sampled.First(way => way.Samples == "16").ErrorLevels;
            yield return new Verdict(
                scene.About, "error of these, as --samples 16", Math.Max(even, target.Error), IsUpperLimit: true, sampled.ErrorLevels,
                sampled.ErrorLevels, Unit.Levels);
        }

        if (result.Targets.TimesFasterThanPovRay is double times)
        {
            double full = all.Fronts.FirstOrDefault(front => front.Scene == scene)?.Of(Settings.PovRayFull)?.Seconds.Median ?? double.NaN;
            yield return new Verdict(
                scene.About, "a further frame, to POV-Ray's at full resolution", times, IsUpperLimit: false, full / further.Median,
                full / further.Minimum, Unit.Times);
        }
    }

    private static IEnumerable<Verdict> OfSequence(SequenceResult? sequence, string name, double framesPerSecond, bool isAlike)
    {
        if (sequence is null)
        {
            yield break;
        }

        string about = FormattableString.Invariant($"{name} of {sequence.Frames} frames");
        yield return AtLeast(
            about, "images and meta files", framesPerSecond, sequence.FramesPerSecond, Unit.FramesPerSecond);
        if (isAlike)
        {
            yield return AtLeast(
                about,
                FormattableString.Invariant($"rate of the last {sequence.WindowFrames} to that of the first"),
                SequenceTargets.MinLastToFirst,
                sequence.LastRate / sequence.FirstRate,
                Unit.Times);
        }

        if (sequence.FirstMemory is { } early && sequence.LastMemory is { } late)
        {
            double growth = (double)late.OwnBytes / early.OwnBytes;
            yield return new Verdict(
                about,
                FormattableString.Invariant($"own memory at the end to that after {sequence.WindowFrames / 2} frames"),
                SequenceTargets.MaxMemoryGrowth,
                IsUpperLimit: true,
                growth,
                growth,
                Unit.Times);
        }
    }

    private static IEnumerable<Verdict> OfLayers(SequenceResult? layers) => layers is null ? [] :
    [
        AtLeast(
            FormattableString.Invariant($"{layers.Frames} frames of it"),
            "with all layers in FITS",
            SequenceTargets.LayeredFramesPerSecond,
            layers.FramesPerSecond,
            Unit.FramesPerSecond),
    ];

    private static IEnumerable<Verdict> OfDetector(DetectorResult? detector) => detector is null ? [] :
    [
        .. detector.Spreads.Select(spread => AtMost($"PSF of 15 x 15 px, {spread.Name}", DetectorTargets.SpreadSeconds, spread.Seconds)),
        .. detector.Noises.Select(noise => AtMost($"all noise, {noise.Name}", DetectorTargets.NoiseSeconds, noise.Seconds)),
    ];

    private static Verdict AtMost(string quantity, double limit, Samples seconds) => new(
        "detector, 1024 x 1024 px", quantity, limit, IsUpperLimit: true, seconds.Median, seconds.Minimum, Unit.Milliseconds);

    private static Verdict AtLeast(string about, string quantity, double limit, double measured, Unit unit) =>
        new(about, quantity, limit, IsUpperLimit: false, measured, measured, unit);
}
