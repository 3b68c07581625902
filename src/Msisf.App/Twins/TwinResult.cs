using Msisf.Adapters.RealImages;
using Msisf.App.Settings;

namespace Msisf.App.Twins;

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
