namespace Msisf.Core.Certainty;

/// <summary>All rays that begin near a point and lead about one way: balls whose radius grows along an axis.</summary>
/// <param name="Origin">m, body-fixed: where the axis begins.</param>
/// <param name="Direction">Direction of the axis, body-fixed, length 1.</param>
/// <param name="Radius">Radius of the ball at the origin, m.</param>
/// <param name="Growth">m per m: by which the radius grows.</param>
internal readonly record struct Beam(Vector3D Origin, Vector3D Direction, double Radius, double Growth)
{
    /// <summary>The middle of the ball at a distance from the origin, m.</summary>
    public Vector3D At(double distance) => Origin + (distance * Direction);

    /// <summary>m: the radius of that ball.</summary>
    public double RadiusAt(double distance) => Radius + (distance * Growth);

    /// <summary>
    /// The distances within limits at which a ball touches the half-space of points x with normal * x at least an offset.
    /// </summary>
    /// <param name="within">m; empty if its low end is above its high one, as the result may be.</param>
    /// <param name="normal">Length 1.</param>
    public Interval Touching(Interval within, Vector3D normal, double offset) => Cut(
        within, Vector3D.Dot(normal, Origin) - offset + Radius, Vector3D.Dot(normal, Direction) + Growth);

    /// <summary>The distances at which the whole ball lies in that half-space.</summary>
    /// <inheritdoc cref="Touching"/>
    public Interval Inside(Interval within, Vector3D normal, double offset) => Cut(
        within, Vector3D.Dot(normal, Origin) - offset - Radius, Vector3D.Dot(normal, Direction) - Growth);

    /// <summary>Where start + rise * t is at least 0.</summary>
    private static Interval Cut(Interval within, double start, double rise)
    {
        if (rise > 0.0)
        {
            return within with { Low = Math.Max(within.Low, -start / rise) };
        }

        double end = rise < 0.0 ? -start / rise : start >= 0.0 ? double.PositiveInfinity : double.NegativeInfinity;
        return within with { High = Math.Min(within.High, end) };
    }
}
