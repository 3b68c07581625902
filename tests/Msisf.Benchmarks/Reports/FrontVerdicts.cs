using System.Globalization;
using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Fronts;
using Msisf.Benchmarks.Measures;

namespace Msisf.Benchmarks.Reports;

/// <summary>
/// Compares what POV-Ray's way costs with the targets of the project's plan; ratios are to the thesis's way in the same run.
/// </summary>
internal static class FrontVerdicts
{
    private const double FromNothingSeconds = 60.0;
    private const double MaxOfThesisBytes = 0.2;
    private const double MaxMemory = 500e6; // bytes

    /// <summary>
    /// Of the error at full resolution: not above it, but for the jitter of antialiasing, which differs from run to run by a
    /// ten-thousandth.
    /// </summary>
    private const double MaxOfFullError = 1.001;

    /// <summary>How many times as fast as the thesis's way, by the scene's name.</summary>
    private static readonly Dictionary<string, double> TimesFaster = new() { ["far-64"] = 15.0, ["nadir-64"] = 8.0 };

    /// <summary>px/deg of the model with which no scene may be slower than by the thesis's way.</summary>
    private const int NeverSlower = 4;

    /// <summary>All that concern the scenes that were measured.</summary>
    public static IEnumerable<Verdict> Of(BenchmarkResult result)
    {
        foreach (SceneFront front in result.Fronts)
        {
            foreach (Verdict verdict in Of(front))
            {
                yield return verdict;
            }
        }

        if (result.FromNothing is FromNothingResult first)
        {
            yield return new Verdict(
                first.About, "first image from nothing but the model's file", FromNothingSeconds, IsUpperLimit: true, first.Seconds,
                first.Seconds, Unit.Seconds);
        }

        foreach (IGrouping<int, SceneFront> fronts in result.Fronts.GroupBy(
            front => (int)front.Scene.Model.Number).OrderBy(group => group.Key))
        {
            yield return Memory(fronts.Key, [.. fronts]);
        }
    }

    private static IEnumerable<Verdict> Of(SceneFront front)
    {
        Scene scene = front.Scene;
        if (TimesFaster.TryGetValue(scene.Name, out double times) || scene.Model.PixelsPerDegree == NeverSlower)
        {
            double min = Math.Max(times, 1.0);
            (double median, double best) = Speed(front);
            yield return new Verdict(
                scene.About, "POV-Ray's image, to the thesis's way", min, IsUpperLimit: false, median, best, Unit.Times);
        }

        SettingResult? povRay = front.Of(Settings.PovRayDefault);
        if (scene.Settings.Contains(Settings.PovRayDefault) && scene.Settings.Contains(Settings.PovRayFull))
        {
            double error = povRay?.Error?.Grey.Rms / front.Of(Settings.PovRayFull)?.Error?.Grey.Rms ?? double.NaN;
            yield return new Verdict(
                scene.About, "rms error of POV-Ray's image, to that at full resolution", MaxOfFullError, IsUpperLimit: true, error, error,
                Unit.Times);
        }

        if (TimesFaster.ContainsKey(scene.Name))
        {
            double disk = povRay?.PatternBytes / front.Of(Settings.Thesis)?.PatternBytes ?? double.NaN;
            yield return new Verdict(
                scene.About, "disk for the scene's patterns, to the thesis's", MaxOfThesisBytes, IsUpperLimit: true, disk, disk,
                Unit.Times);
        }
    }

    private static (double Median, double Best) Speed(SceneFront front) =>
        front.Of(Settings.PovRayDefault) is SettingResult povRay && front.Of(Settings.Thesis) is SettingResult thesis
            ? (thesis.Seconds.Median / povRay.Seconds.Median, thesis.Seconds.Minimum / povRay.Seconds.Minimum)
            : (double.NaN, double.NaN);

    /// <summary>Of msis itself in all images by POV-Ray with the program's defaults.</summary>
    private static Verdict Memory(int pixelsPerDegree, IReadOnlyList<SceneFront> fronts)
    {
        double[] peaks = [.. fronts.Select(front => front.Of(Settings.PovRayDefault)?.Timing.PeakMemoryBytes ?? double.NaN)];
        string about = string.Create(CultureInfo.InvariantCulture, $"LDEM_{pixelsPerDegree}, {peaks.Length} scenes");
        return new Verdict(about, "memory of msis with POV-Ray", MaxMemory, IsUpperLimit: true, peaks.Max(), peaks.Min(), Unit.Megabytes);
    }
}
