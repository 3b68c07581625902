using System.Globalization;
using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Measures;
using Msisf.Benchmarks.Programs;

namespace Msisf.Benchmarks.Reports;

/// <summary>Every measured figure, for the CSV file.</summary>
internal static class FigureList
{
    public static Table ToTable(BenchmarkResult result)
    {
        Table table = new("scene", "quantity", "setting", "unit", "count", "minimum", "median", "maximum");
        foreach (Figure figure in Of(result))
        {
            table.Add(
                figure.Scene, figure.Quantity, figure.Setting, figure.Unit, figure.Values.Count.ToString(CultureInfo.InvariantCulture),
                Number(figure.Values.Minimum), Number(figure.Values.Median), Number(figure.Values.Maximum));
        }

        return table;
    }

    /// <summary>In words, e.g. "2 threads, 512-bit vectors".</summary>
    public static string SettingOf(FurtherFramesResult result) => string.Create(
        CultureInfo.InvariantCulture,
        $"{result.Threads} thread{(result.Threads == 1 ? string.Empty : "s")}, AVX-512 {(result.HasVector512 ? "on" : "off")}");

    private static string Number(double value) => value.ToString("R", CultureInfo.InvariantCulture);

    private static IEnumerable<Figure> Of(BenchmarkResult result) =>
    [
        .. result.Scenes.SelectMany(Of),
        .. result.Sequence is null ? [] : Of(Scenes.Sequence, result.Sequence),
        .. result.Layers is null ? [] : Of("sequence with layers", result.Layers),
        .. result.Descent is null ? [] : Of(Scenes.Descent, result.Descent),
        .. result.Detector is null ? [] : Of(result.Detector),
    ];

    private static IEnumerable<Figure> Of(SceneResult result)
    {
        string name = result.Scene.Name;
        yield return new Figure(name, "first frame", "native", "s", result.First.Seconds);
        foreach ((string phase, Samples seconds) in result.First.Phases)
        {
            yield return new Figure(name, $"first frame, {phase}", "native", "s", seconds);
        }

        yield return new Figure(name, "peak memory", "native", "bytes", result.First.PeakMemoryBytes);
        foreach (FurtherFramesResult further in result.Further)
        {
            string setting = SettingOf(further);
            yield return new Figure(name, "further frame", setting, "s", new Samples(further.FrameSeconds));
            yield return Single(name, "peak memory of further frames", setting, "bytes", further.PeakMemoryBytes);
            yield return Single(name, "pixels checked", setting, "1", further.CheckedPixels);
            yield return Single(name, "pixels with another facet than the exact tracer's", setting, "1", further.OtherFacets);
            yield return Single(name, "pixels lit otherwise than by the exact tracer", setting, "1", further.OtherLight);
            yield return Single(name, "largest distance to the exact tracer's hit", setting, "m", further.LargestDistance);
        }

        foreach (Figure figure in result.Sampled.SelectMany(sampled => Of(name, sampled)))
        {
            yield return figure;
        }
    }

    private static IEnumerable<Figure> Of(string name, SampledFramesResult result)
    {
        string setting = $"--samples {result.Samples}";
        yield return new Figure(name, "further frame", setting, "s", new Samples(result.FrameSeconds));
        yield return Single(name, "rms error against 64 samples", setting, "levels", result.ErrorLevels);
    }

    private static IEnumerable<Figure> Of(string name, SequenceResult result)
    {
        yield return Single(name, "frames", string.Empty, "1", result.Frames);
        yield return Single(name, "rate", "all frames", "1/s", result.FramesPerSecond);
        yield return Single(name, "rate", "first frames", "1/s", result.FirstRate);
        yield return Single(name, "rate", "last frames", "1/s", result.LastRate);
        yield return Single(name, "rate", "slowest frames", "1/s", result.SlowestRate);
        yield return Single(name, "files", string.Empty, "bytes", result.Bytes);
        yield return Single(name, "files", "written", "bytes/s", result.BytesPerSecond);
        yield return Single(name, "peak memory", string.Empty, "bytes", result.PeakMemoryBytes);
        foreach (Figure figure in OfMemory(name, "first frames", result.FirstMemory).Concat(
            OfMemory(name, "last frames", result.LastMemory)))
        {
            yield return figure;
        }
    }

    private static IEnumerable<Figure> Of(DetectorResult result) =>
    [
        .. result.Spreads.Select(spread => new Figure(Scenes.Detector, "point spread", spread.Name, "s", spread.Seconds)),
        .. result.Noises.Select(noise => new Figure(Scenes.Detector, "all noise", noise.Name, "s", noise.Seconds)),
    ];

    private static IEnumerable<Figure> OfMemory(string name, string when, MemorySample? memory) => memory is not MemorySample sample ? [] :
    [
        Single(name, "own memory", when, "bytes", sample.OwnBytes),
        Single(name, "pages of mapped files", when, "bytes", sample.FileBytes),
    ];

    private static Figure Single(string scene, string quantity, string setting, string unit, double value) =>
        new(scene, quantity, setting, unit, new Samples([value]));
}
