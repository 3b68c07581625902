using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Measures;

namespace Msisf.Benchmarks.Reports;

/// <summary>Compares what was measured with the targets. Times count by their median, memory by its most.</summary>
internal static class Verdicts
{
    public static IEnumerable<Verdict> Of(BenchmarkResult result) =>
        [.. result.Scenes.SelectMany(Of), .. OfSequence(result.Sequence), .. OfLayers(result.Layers)];

    private static IEnumerable<Verdict> Of(SceneResult result)
    {
        Scene scene = result.Scene;
        Samples first = result.First.Seconds;
        Samples further = result.UsualFurtherSeconds;
        Samples memory = result.First.PeakMemoryBytes;
        yield return new Verdict(
            scene.About, "first frame, from process start", scene.Targets.FirstSeconds, IsUpperLimit: true, first.Median, first.Minimum, Unit.Milliseconds);
        yield return new Verdict(
            scene.About, "further frames", scene.Targets.FurtherSeconds, IsUpperLimit: true, further.Median, further.Minimum, Unit.Milliseconds);
        yield return new Verdict(
            scene.About, "memory", scene.Targets.MemoryBytes, IsUpperLimit: true, memory.Maximum, memory.Minimum, Unit.Megabytes);
        if (scene.Targets.TimesFasterThanPovRay is double times && result.TimesFasterThanPovRay(further.Median) is double measured)
        {
            yield return new Verdict(
                scene.About, "POV-Ray's way to a further frame", times, IsUpperLimit: false, measured, result.TimesFasterThanPovRay(further.Minimum)!.Value, Unit.Times);
        }
    }

    private static IEnumerable<Verdict> OfSequence(SequenceResult? sequence)
    {
        if (sequence is null)
        {
            yield break;
        }

        string about = FormattableString.Invariant($"orbit of {sequence.Frames} frames");
        yield return AtLeast(about, "pictures and meta files", SequenceTargets.FramesPerSecond, sequence.FramesPerSecond, Unit.FramesPerSecond);
        yield return AtLeast(
            about,
            FormattableString.Invariant($"rate of the last {sequence.WindowFrames} to that of the first"),
            SequenceTargets.LeastLastToFirst,
            sequence.LastRate / sequence.FirstRate,
            Unit.Times);
        if (sequence.FirstMemory is { } early && sequence.LastMemory is { } late)
        {
            double growth = (double)late.OwnBytes / early.OwnBytes;
            yield return new Verdict(
                about, "own memory at the end to that at the start", SequenceTargets.MostMemoryGrowth, IsUpperLimit: true, growth, growth, Unit.Times);
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

    private static Verdict AtLeast(string about, string quantity, double limit, double measured, Unit unit) =>
        new(about, quantity, limit, IsUpperLimit: false, measured, measured, unit);
}
