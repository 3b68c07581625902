using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;

namespace Msisf.Core.Metadata;

/// <summary>The elevation model of a frame, and the levels of detail that the frame was drawn at.</summary>
/// <param name="ProductId">Name of the model, e.g. "LDEM_64".</param>
/// <param name="IsSynthetic">Whether the model is synthetic, not the real Moon.</param>
/// <param name="FinestDrawn">Resolution of the finest level in the image; the model's own where that was drawn.</param>
/// <param name="CoarsestDrawn">Resolution of the coarsest level in the image; the native renderer draws an image at one level.</param>
public sealed record DrawnElevation(
    string ProductId, bool IsSynthetic, GridResolution Resolution, GridResolution FinestDrawn, GridResolution CoarsestDrawn)
{
    /// <summary>The models of a scene of several, in the order of a facet's parts; empty for one.</summary>
    public IReadOnlyList<ElevationPart> Parts { get; init; } = [];
}

/// <summary>One of several elevation models of a frame.</summary>
/// <param name="ProductId">Name of the model, e.g. "LDEM_80S_80M".</param>
/// <param name="IsSynthetic">Whether the model is synthetic, not the real Moon.</param>
/// <param name="Drawn">Resolution of the level in the image; null for a model that is left out, because a coarser one is as fine.</param>
public sealed record ElevationPart(string ProductId, bool IsSynthetic, GridResolution Resolution, GridResolution? Drawn)
{
    /// <summary>How far the user moved the model; null if not at all.</summary>
    public PartMove? Moved { get; init; }

    /// <summary>How far the model is off those around it along its border; null for the coarsest, and where that is not said.</summary>
    public PartMisfit? Misfit { get; init; }
}

/// <summary>How far a model was moved before it was drawn; <c>default</c> is not at all.</summary>
/// <param name="Offset">m upwards.</param>
/// <param name="East">m towards the east.</param>
/// <param name="North">m towards the north.</param>
public readonly record struct PartMove(double Offset, double East, double North);

/// <summary>How far a model is off those around it along its border: mean, root of the mean square, and the one farthest from 0.</summary>
/// <param name="HeightMean">m: its height less that of the models around it.</param>
/// <param name="HeightRms">m.</param>
/// <param name="HeightGreatest">m.</param>
/// <param name="SlopeMean">Degrees: how much more steeply it rises inwards.</param>
/// <param name="SlopeRms">Degrees.</param>
/// <param name="SlopeGreatest">Degrees.</param>
public sealed record PartMisfit(
    double HeightMean, double HeightRms, double HeightGreatest, double SlopeMean, double SlopeRms, double SlopeGreatest)
{
    /// <summary>Takes what was found of a border.</summary>
    public static PartMisfit Of(BorderMisfit misfit)
    {
        (MisfitNumbers height, MisfitNumbers slope) = (misfit.Height, misfit.Slope);
        return new PartMisfit(height.Mean, height.Rms, height.Greatest, Degrees(slope.Mean), Degrees(slope.Rms), Degrees(slope.Greatest));
    }

    private static double Degrees(double tangent) => double.RadiansToDegrees(Math.Atan(tangent));
}
