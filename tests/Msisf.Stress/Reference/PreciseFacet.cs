using Msisf.Core.Numerics;

namespace Msisf.Stress.Reference;

/// <summary>
/// A facet of the terrain and rays, to some 30 digits; its corners count as exact, and are counter-clockwise seen from outside.
/// </summary>
/// <param name="A">m, MOON_ME.</param>
/// <param name="B">m, MOON_ME.</param>
/// <param name="C">m, MOON_ME.</param>
public readonly record struct PreciseFacet(PreciseVector A, PreciseVector B, PreciseVector C)
{
    private PreciseVector Normal => PreciseVector.Cross(B - A, C - A);

    /// <summary>Takes corners in doubles.</summary>
    public static PreciseFacet From((Vector3D A, Vector3D B, Vector3D C) corners) =>
        new(PreciseVector.From(corners.A), PreciseVector.From(corners.B), PreciseVector.From(corners.C));

    /// <summary>Cosine between a ray backwards and the outward normal: above 0 if the ray comes from outside.</summary>
    public double Cosine(PreciseVector direction) =>
        -(PreciseVector.Dot(Normal, direction) / (Normal.Length * direction.Length)).High;

    /// <summary>Parameter at which a ray meets the facet's plane.</summary>
    public DoubleWord ParameterOn(PreciseVector origin, PreciseVector direction) =>
        PreciseVector.Dot(Normal, A - origin) / PreciseVector.Dot(Normal, direction);

    /// <summary>
    /// How far inside the facet a ray enters the ground, m from its nearest edge; below 0 outside; minus infinity if it comes from below or
    /// lies behind.
    /// </summary>
    /// <param name="origin">m, MOON_ME.</param>
    /// <param name="direction">Any length.</param>
    public double Inside(PreciseVector origin, PreciseVector direction) =>
        PreciseVector.Dot(Normal, direction).High < 0.0 && ParameterOn(origin, direction).High > 0.0
            ? Math.Min(Left(origin, direction, A, B), Math.Min(Left(origin, direction, B, C), Left(origin, direction, C, A)))
            : double.NegativeInfinity;

    /// <summary>m: how far on the left of an edge, seen from outside, a ray passes that enters the ground.</summary>
    private static double Left(PreciseVector origin, PreciseVector direction, PreciseVector from, PreciseVector to)
    {
        DoubleWord volume = PreciseVector.Dot(direction, PreciseVector.Cross(from - origin, to - origin));
        return -(volume / PreciseVector.Cross(direction, to - from).Length).High;
    }
}
