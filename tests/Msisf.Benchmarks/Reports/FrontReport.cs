using System.Globalization;
using System.Text;
using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Fronts;
using Msisf.TestSupport.Images;

namespace Msisf.Benchmarks.Reports;

/// <summary>A scene's table of time against error, with its plot.</summary>
internal static class FrontReport
{
    private const string NotMeasured = "-";

    /// <summary>Adds the scene's part of the report.</summary>
    public static void Append(StringBuilder text, SceneFront front)
    {
        text.Append(CultureInfo.InvariantCulture, $"### {Capital(front.Scene.About)}\n\n");
        if (front.Results.Any(result => result.Error is not null))
        {
            text.Append(
                CultureInfo.InvariantCulture, $"![Time against error: {front.Scene.About}](front-{front.Scene.Name}.svg)\n\n");
        }

        text.Append(Costs(front).ToMarkdown()).Append('\n');
        text.Append(Errors(front).ToMarkdown()).Append('\n');
        foreach (SettingResult result in front.Results.Where(result => result.IsScaled))
        {
            text.Append(
                CultureInfo.InvariantCulture,
                $"{Capital(result.Setting.Name)}: scaled. {Seconds(Measured(result))} s for {result.MeasuredTiles} of {result.Tiles} "
                    + $"tiles were measured; the time of parsing, the bytes and the triangles are multiplied by "
                    + $"{result.Tiles}/{result.MeasuredTiles}, the other times are as measured.\n\n");
        }

        foreach ((Setting setting, string message) in front.Failures)
        {
            text.Append(CultureInfo.InvariantCulture, $"{Capital(setting.Name)}: failed. {message}\n\n");
        }
    }

    private static Table Costs(SceneFront front)
    {
        Table table = new(
            "way",
            "s",
            "to thesis",
            "start-up",
            "selection",
            "patterns",
            "parse",
            "trace or draw",
            "output",
            "msis, MB",
            "POV-Ray, MB",
            "tiles",
            "triangles, 1000",
            "patterns, MB");
        foreach (SettingResult result in front.Results)
        {
            bool hasPatterns = result.Patterns is not null;
            table.Add(
                result.Setting.Name,
                Seconds(result.Seconds.Median) + (result.IsScaled ? " (scaled)" : string.Empty),
                front.TimesFasterThanThesis(result) is double times ? Unit.Times.Text(times) : NotMeasured,
                Phase(result, "start_up"),
                Phase(result, "selection"),
                Phase(result, "patterns"),
                Phase(result, "parse"),
                Phase(result, "trace", "draw"),
                Phase(result, "output", "xml"),
                Unit.Megabytes.Number(result.Timing.PeakMemoryBytes),
                result.PovRayPeakBytes > 0.0 ? Unit.Megabytes.Number(result.PovRayPeakBytes) : NotMeasured,
                hasPatterns ? result.Tiles.ToString(CultureInfo.InvariantCulture) : NotMeasured,
                hasPatterns ? Unit.Thousands.Number(result.Triangles) : NotMeasured,
                hasPatterns ? Unit.Megabytes.Number(result.PatternBytes) : NotMeasured);
        }

        return table;
    }

    private static Table Errors(SceneFront front)
    {
        Table table = new(
            "way",
            "pixels off by more than a level, %",
            "rms, levels",
            "light wrong, %",
            "limb, rms and largest, px",
            "hits: median, rms, largest, m");
        foreach (SettingResult result in front.Results)
        {
            ImageError? error = result.Error;
            table.Add(
                result.Setting.Name,
                error is null ? NotMeasured : Unit.Percent.Number(error.Grey.DifferingFraction),
                error is null ? NotMeasured : Unit.Levels.Number(error.Grey.Rms),
                error is null ? NotMeasured : Unit.Percent.Number(error.Light.Fraction),
                error is { Limb: { Points: > 0 } limb }
                    ? $"{Unit.Pixels.Number(limb.Rms)}, {Unit.Pixels.Number(limb.Largest)}"
                    : NotMeasured,
                result.Hits is HitDistance hits ? $"{Metres(hits.Median)}, {Metres(hits.Rms)}, {Metres(hits.Largest)}" : NotMeasured);
        }

        return table;
    }

    private static double Measured(SettingResult result) => result.FirstSeconds - result.Timing.SecondsOf("patterns");

    private static string Phase(SettingResult result, params string[] names) => Seconds(names.Sum(result.Timing.SecondsOf));

    private static string Seconds(double value) => Unit.Seconds.Number(value);

    /// <summary>Two digits: it goes over fourteen powers of ten.</summary>
    private static string Metres(double value) => value.ToString("G2", CultureInfo.InvariantCulture);

    private static string Capital(string text) => char.ToUpperInvariant(text[0]) + text[1..];
}
