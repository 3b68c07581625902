using System.Text.Json;
using Msisf.Adapters.RealImages;
using Msisf.App.Settings;
using Msisf.Core.Comparison;

namespace Msisf.App.Twins;

/// <summary>Writes the numbers of a twin for programs.</summary>
internal sealed class TwinJson(TwinResult result)
{
    private static readonly JsonSerializerOptions Indented = new() { WriteIndented = true, NewLine = "\n" };

    public void Write(Stream stream)
    {
        TwinComparison? found = result.Comparison;
        JsonSerializer.Serialize(
            stream,
            new Dictionary<string, object?>
            {
                ["label"] = Path.GetFileName(result.Label.Path),
                ["kind"] = result.Label.Kind,
                ["camera"] = result.Camera.Name,
                ["version"] = result.Version,
                ["image"] = result.Image,
                ["band"] = result.Band.Index + 1,
                ["nanometres"] = result.Band.Nanometres,
                ["samples"] = result.Plan.Pixels.Samples,
                ["lines"] = result.Plan.Pixels.Lines,
                ["cameraPixelsOfOne"] = new[] { result.Plan.Pixels.SampleStep, result.Plan.Pixels.LineStep },
                ["firstExposureTdb"] = result.Plan.Start,
                ["period"] = result.Plan.Period,
                ["exposures"] = result.Plan.Exposures,
                ["reflectance"] = result.Settings.Native.ReflectanceText,
                ["sunOffsetDegrees"] = result.SunOffsetDegrees,
                ["comparison"] = found is null ? null : new Dictionary<string, object?>
                {
                    ["pixels"] = found.Agreement.Count,
                    ["correlation"] = found.Agreement.Correlation,
                    ["relativeRms"] = found.Agreement.Rms,
                    ["factor"] = found.Agreement.Factor,
                    ["byPhase"] = found.ByPhase.Select(part => new Dictionary<string, object?>
                    {
                        ["from"] = part.Low,
                        ["to"] = part.High,
                        ["pixels"] = part.Agreement.Count,
                        ["correlation"] = part.Agreement.Correlation,
                        ["relativeRms"] = part.Agreement.Rms,
                        ["ratio"] = part.Ratio,
                    }),
                    ["shift"] = found.Whole is { } whole ? ShiftOf(whole) : null,
                    ["blockSide"] = ShiftFinder.BlockSide,
                    ["blocks"] = found.Blocks.Select(block => new Dictionary<string, object?>
                    {
                        ["sample"] = block.Left + 1,
                        ["line"] = block.Top + 1,
                        ["width"] = block.Width,
                        ["height"] = block.Height,
                        ["shift"] = block.Shift is { } shift ? ShiftOf(shift) : null,
                    }),
                },
            },
            Indented);
        stream.WriteByte((byte)'\n');
    }

    private static Dictionary<string, double> ShiftOf(ImageShift shift) => new()
    {
        ["right"] = shift.Right,
        ["down"] = shift.Down,
        ["correlation"] = shift.Correlation,
        ["unshifted"] = shift.Unshifted,
    };
}

/// <summary>A twin and what is known of it.</summary>
/// <param name="Label">Label of the real image.</param>
/// <param name="Plan">How it was drawn.</param>
/// <param name="Settings">Of the run that drew it.</param>
/// <param name="Version">Of the program.</param>
internal sealed record TwinResult(
    ImageLabel Label, TwinCamera Camera, TwinBand Band, TwinPlan Plan, RenderSettings Settings, string Version)
{
    /// <summary>I/F, by lines of the product; NaN where nothing is drawn.</summary>
    public required float[] Drawn { get; init; }

    /// <summary>degrees: how far the Sun of the cube's table is from the drawn one; null without a table.</summary>
    public required double? SunOffsetDegrees { get; init; }

    /// <summary>Name of the drawn image.</summary>
    public required string Image { get; init; }

    /// <summary>The comparison; null without pixels of the real image.</summary>
    public required TwinComparison? Comparison { get; init; }
}
