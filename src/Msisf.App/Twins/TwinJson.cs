using System.Text.Json;
using System.Text.Json.Nodes;
using Msisf.Adapters.RealImages;
using Msisf.App.Settings;
using Msisf.Core.Comparison;

namespace Msisf.App.Twins;

/// <summary>Writes the numbers of a twin for programs.</summary>
internal sealed class TwinJson(TwinResult result)
{
    private static readonly JsonWriterOptions Indented = new() { Indented = true, NewLine = "\n" };

    public void Write(Stream stream)
    {
        TwinComparison? found = result.Comparison;
        JsonObject card = new()
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
            ["cameraPixelsOfOne"] = new JsonArray(result.Plan.Pixels.SampleStep, result.Plan.Pixels.LineStep),
            ["firstExposureTdb"] = result.Plan.Start,
            ["period"] = result.Plan.Period,
            ["exposures"] = result.Plan.Exposures,
            ["reflectance"] = result.Settings.Native.ReflectanceText,
            ["sunOffsetDegrees"] = result.SunOffsetDegrees,
            ["comparison"] = found is null ? null : new JsonObject
            {
                ["pixels"] = found.Agreement.Count,
                ["correlation"] = found.Agreement.Correlation,
                ["relativeRms"] = found.Agreement.Rms,
                ["factor"] = found.Agreement.Factor,
                ["byPhase"] = new JsonArray([.. found.ByPhase.Select(part => new JsonObject
                {
                    ["from"] = part.Low,
                    ["to"] = part.High,
                    ["pixels"] = part.Agreement.Count,
                    ["correlation"] = part.Agreement.Correlation,
                    ["relativeRms"] = part.Agreement.Rms,
                    ["ratio"] = part.Ratio,
                })]),
                ["shift"] = found.Whole is { } whole ? ShiftOf(whole) : null,
                ["blockSide"] = ShiftFinder.BlockSide,
                ["blocks"] = new JsonArray([.. found.Blocks.Select(block => new JsonObject
                {
                    ["sample"] = block.Left + 1,
                    ["line"] = block.Top + 1,
                    ["width"] = block.Width,
                    ["height"] = block.Height,
                    ["shift"] = block.Shift is { } shift ? ShiftOf(shift) : null,
                })]),
            },
        };
        using Utf8JsonWriter writer = new(stream, Indented);
        card.WriteTo(writer);
        writer.Flush();
        stream.WriteByte((byte)'\n');
    }

    private static JsonObject ShiftOf(ImageShift shift) => new()
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
/// <param name="Settings">Settings of the run that drew it.</param>
/// <param name="Version">Version of the program.</param>
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
