using System.Globalization;
using System.Text;
using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Fronts;
using Msisf.Benchmarks.Measures;
using Msisf.Benchmarks.Programs;

namespace Msisf.Benchmarks.Reports;

/// <summary>The tables of every scene, for results/performance-tables.md.</summary>
internal static class MarkdownReport
{
    private const string NotMeasured = "-";

    public static string Write(BenchmarkResult result)
    {
        StringBuilder text = new();
        text.Append(result.Machine).Append("\n\n");
        Append(text, "Targets: times by their median, memory by its maximum.", Targets(result));
        foreach (SceneFront front in result.Fronts)
        {
            FrontReport.Append(text, front);
        }

        if (result.Scenes.Count > 0)
        {
            Append(
                text,
                "The native renderer's first frame: a process of its own, all files written; minimum / median. "
                    + "Phases are medians of `--timing`.",
                FirstFrames(result.Scenes));
            Append(text, "Its further frames in one process, ms to draw one; minimum / median.", FurtherFrames(result.Scenes));
            Append(
                text,
                "With several samples a pixel, ms to draw one, minimum / median; rms error of one against 64 samples in every pixel, "
                    + "levels of 255.",
                SampledFrames(result.Scenes));
        }

        if (result.Sequence is not null || result.Descent is not null)
        {
            Append(text, "Sequences: one process, from its start to its end.", Sequences(result));
        }

        return text.ToString().TrimEnd('\n') + "\n";
    }

    private static void Append(StringBuilder text, string title, Table table) =>
        text.Append(title).Append("\n\n").Append(table.ToMarkdown()).Append('\n');

    private static Table Targets(BenchmarkResult result)
    {
        Table table = new("scene", "figure", "target", "measured", "best", "");
        foreach (Verdict verdict in Verdicts.Of(result))
        {
            string bound = verdict.IsUpperLimit ? "at most" : "at least";
            table.Add(
                verdict.Scene,
                verdict.Quantity,
                $"{bound} {verdict.Unit.Text(verdict.Limit)}",
                verdict.Unit.Number(verdict.Measured),
                verdict.Unit.Number(verdict.Best),
                verdict.Word);
        }

        return table;
    }

    private static Table FirstFrames(IReadOnlyList<SceneResult> scenes)
    {
        string[] phases = [.. scenes.SelectMany(scene => scene.First.Phases.Select(phase => phase.Phase)).Distinct()];
        Table table = new(["scene", "ms", .. phases.Select(phase => phase.Replace('_', '-')), "memory, MB"]);
        foreach (SceneResult scene in scenes)
        {
            Dictionary<string, Samples> seconds = scene.First.Phases.ToDictionary(phase => phase.Phase, phase => phase.Seconds);
            table.Add(
            [
                scene.Scene.About,
                Range(Unit.Milliseconds, scene.First.Seconds),
                .. phases.Select(
                    phase => seconds.TryGetValue(phase, out Samples? values) ? Unit.Milliseconds.Number(values.Median) : NotMeasured),
                Unit.Megabytes.Number(scene.First.PeakMemoryBytes.Maximum),
            ]);
        }

        return table;
    }

    private static Table FurtherFrames(IReadOnlyList<SceneResult> scenes)
    {
        string[] settings = [.. scenes.SelectMany(scene => scene.Further.Select(FigureList.SettingOf)).Distinct()];
        Table table = new(["scene", .. settings, "drawn", "memory, MB", "unlike the exact tracer: facet, light"]);
        foreach (SceneResult scene in scenes)
        {
            Dictionary<string, FurtherFramesResult> results = scene.Further.ToDictionary(FigureList.SettingOf);
            table.Add(
            [
                scene.Scene.About,
                .. settings.Select(setting => results.TryGetValue(setting, out FurtherFramesResult? further)
                    ? Range(Unit.Milliseconds, new Samples(further.FrameSeconds))
                    : NotMeasured),
                scene.Further[0].Resolution,
                Unit.Megabytes.Number(scene.Further.Max(further => further.PeakMemoryBytes)),
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"{scene.Further.Sum(further => further.OtherFacets)}, "
                        + $"{scene.Further.Sum(further => further.OtherLight)} of {scene.Further.Sum(further => further.CheckedPixels)}"),
            ]);
        }

        return table;
    }

    private static Table SampledFrames(IReadOnlyList<SceneResult> scenes)
    {
        Table table = new("scene", "--samples", "ms", "error");
        foreach (SceneResult scene in scenes)
        {
            foreach (SampledFramesResult sampled in scene.Sampled)
            {
                table.Add(
                    scene.Scene.About, sampled.Samples, Range(Unit.Milliseconds, new Samples(sampled.FrameSeconds)),
                    Unit.Levels.Number(sampled.ErrorLevels));
            }
        }

        return table;
    }

    private static Table Sequences(BenchmarkResult result)
    {
        Table table = new(
            "files", "frames", "frames/s", "first tenth", "last tenth", "slowest tenth", "MB/s", "peak memory, MB",
            "own memory, first and last tenth, MB");
        foreach ((string files, SequenceResult? sequence) in ((string, SequenceResult?)[])[("PNG, XML", result.Sequence), (
            "and all layers, FITS", result.Layers), ("descent through five maps, PNG, XML", result.Descent)])
        {
            if (sequence is not null)
            {
                table.Add(
                    files,
                    sequence.Frames.ToString(CultureInfo.InvariantCulture),
                    Unit.FramesPerSecond.Number(sequence.FramesPerSecond),
                    Unit.FramesPerSecond.Number(sequence.FirstRate),
                    Unit.FramesPerSecond.Number(sequence.LastRate),
                    Unit.FramesPerSecond.Number(sequence.SlowestRate),
                    Unit.Megabytes.Number(sequence.BytesPerSecond),
                    Unit.Megabytes.Number(sequence.PeakMemoryBytes),
                    $"{OwnMemory(sequence.FirstMemory)}, {OwnMemory(sequence.LastMemory)}");
            }
        }

        return table;
    }

    private static string OwnMemory(MemorySample? sample) =>
        sample is MemorySample seen ? Unit.Megabytes.Number(seen.OwnBytes) : NotMeasured;

    private static string Range(Unit unit, Samples values) => values.Count == 1
        ? unit.Number(values.Median)
        : $"{unit.Number(values.Minimum)} / {unit.Number(values.Median)}";
}
