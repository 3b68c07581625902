using System.Globalization;
using Msisf.Benchmarks.Fronts;

namespace Msisf.Benchmarks.Reports;

/// <summary>
/// Time and error of every way to make every image, for the CSV file and its plots. SI units; an empty field was not measured.
/// </summary>
internal static class FrontFigures
{
    private static readonly (string Name, Func<SettingResult, double?> Value)[] Columns =
    [
        ("seconds_minimum", result => result.Seconds.Minimum),
        ("seconds_median", result => result.Seconds.Median),
        ("seconds_maximum", result => result.Seconds.Maximum),
        ("images", result => result.Seconds.Count),
        ("first_seconds", result => result.FirstSeconds),
        ("tiles", result => result.Tiles),
        ("tiles_measured", result => result.MeasuredTiles),
        ("start_up_s", result => result.Timing.SecondsOf("start_up")),
        ("selection_s", result => result.Timing.SecondsOf("selection")),
        ("patterns_s", result => result.Timing.SecondsOf("patterns")),
        ("pov_ray_s", result => result.Timing.SecondsOf("pov_ray")),
        ("parse_s", result => result.Timing.SecondsOf("parse")),
        ("trace_s", result => result.Timing.SecondsOf("trace")),
        ("draw_s", result => result.Timing.SecondsOf("draw")),
        ("output_s", result => result.Timing.SecondsOf("output") + result.Timing.SecondsOf("xml")),
        ("msis_peak_bytes", result => result.Timing.PeakMemoryBytes),
        ("povray_peak_bytes", result => result.PovRayPeakBytes),
        ("pattern_bytes", result => result.Patterns is null ? null : result.PatternBytes),
        ("triangles", result => result.Patterns is null ? null : result.Triangles),
        ("differing_fraction", result => result.Error?.Grey.DifferingFraction),
        ("grey_rms_levels", result => result.Error?.Grey.Rms),
        ("grey_largest_levels", result => result.Error?.Grey.Largest),
        ("light_wrong_fraction", result => result.Error?.Light.Fraction),
        ("limb_points", result => result.Error?.Limb.Points),
        ("limb_rms_px", result => result.Error?.Limb.Rms),
        ("limb_largest_px", result => result.Error?.Limb.Largest),
        ("hit_pixels", result => result.Hits?.Pixels),
        ("hit_one_sided", result => result.Hits?.OneSided),
        ("hit_median_m", result => result.Hits?.Median),
        ("hit_rms_m", result => result.Hits?.Rms),
        ("hit_largest_m", result => result.Hits?.Largest),
    ];

    /// <summary>A line for each way to make each image.</summary>
    public static Table ToTable(IReadOnlyList<SceneFront> fronts)
    {
        Table table = new(["scene", "about", "setting", "kind", .. Columns.Select(column => column.Name)]);
        foreach (SceneFront front in fronts)
        {
            foreach (SettingResult result in front.Results)
            {
                table.Add(
                [
                    front.Scene.Name, front.Scene.About, result.Setting.Name, result.Setting.Kind.ToString(),
                    .. Columns.Select(column => column.Value(result)?.ToString("R", CultureInfo.InvariantCulture) ?? string.Empty),
                ]);
            }
        }

        return table;
    }
}
