using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Light space: the projective map of MOON_ME that makes all rays to the Sun's centre parallel to its third axis. A point with the
/// components (u, v, w) along three axes from the Moon's centre, w away from the Sun, becomes (u, v, w) D / (D + w), with D the Sun's
/// distance from the Moon's centre. Planes stay planes, and orientation is kept. The one of two points on a ray nearer to the Sun has
/// the smaller third coordinate, the depth.
/// </summary>
/// <remarks>
/// Valid for points nearer to the Moon's centre than the Sun. Scalar and vector code do the same operations in the same order, and
/// none is a fused multiply-add, so they give the same bits. Rounding moves a point by less than 1e-9 m.
/// </remarks>
internal sealed class LightFrame
{
    /// <summary>Makes the light space of a position of the Sun.</summary>
    /// <param name="sunBodyFixed">The Sun's centre, m, body-fixed.</param>
    /// <param name="towardsBodyFixed">MOON_ME; its part across the Sun's direction gives the first axis; any vector is valid.</param>
    public LightFrame(Vector3D sunBodyFixed, Vector3D towardsBodyFixed)
    {
        SunDistance = sunBodyFixed.Length;
        AxisW = -sunBodyFixed / SunDistance;
        AxisU = Across(AxisW, towardsBodyFixed);
        AxisV = Vector3D.Cross(AxisW, AxisU);
    }

    /// <summary>Distance D of the Sun's centre from the Moon's centre, m.</summary>
    public double SunDistance { get; }

    /// <summary>Unit vector across the Sun's direction, body-fixed; U, V and W are right-handed.</summary>
    public Vector3D AxisU { get; }

    /// <inheritdoc cref="AxisU"/>
    public Vector3D AxisV { get; }

    /// <summary>Unit vector away from the Sun, body-fixed.</summary>
    public Vector3D AxisW { get; }

    /// <summary>Converts a point from MOON_ME to light space, m.</summary>
    /// <param name="pointBodyFixed">The point, m, body-fixed.</param>
    public Vector3D FromBodyFixed(Vector3D pointBodyFixed)
    {
        double w = Vector3D.Dot(pointBodyFixed, AxisW);
        double scale = SunDistance / (SunDistance + w);
        return new Vector3D(scale * Vector3D.Dot(pointBodyFixed, AxisU), scale * Vector3D.Dot(pointBodyFixed, AxisV), scale * w);
    }

    /// <summary>Converts points in place to light space, with the same bits as <see cref="FromBodyFixed(Vector3D)"/>.</summary>
    /// <param name="x">m, body-fixed x; becomes u. The length is a multiple of 8.</param>
    /// <param name="y">m, body-fixed y; becomes v.</param>
    /// <param name="z">m, body-fixed z; becomes w.</param>
    public void FromBodyFixed(Span<double> x, Span<double> y, Span<double> z)
    {
        Vector512<double> distance = Vector512.Create(SunDistance);
        for (int i = 0; i < x.Length; i += Vector512<double>.Count)
        {
            Vector512<double> px = ArrayLanes.Load(x, i);
            Vector512<double> py = ArrayLanes.Load(y, i);
            Vector512<double> pz = ArrayLanes.Load(z, i);
            Vector512<double> w = Dot(px, py, pz, AxisW);
            Vector512<double> scale = distance / (distance + w);
            (scale * Dot(px, py, pz, AxisU)).StoreTo(x, i);
            (scale * Dot(px, py, pz, AxisV)).StoreTo(y, i);
            (scale * w).StoreTo(z, i);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Dot(Vector512<double> x, Vector512<double> y, Vector512<double> z, Vector3D axis) =>
        (x * Vector512.Create(axis.X)) + (y * Vector512.Create(axis.Y)) + (z * Vector512.Create(axis.Z));

    private static Vector3D Across(Vector3D axis, Vector3D towards)
    {
        Vector3D across = towards - (Vector3D.Dot(towards, axis) * axis);
        if (across.Length <= 1e-3 * towards.Length)
        {
            // The vector is almost parallel to the axis: a coordinate axis that is not near it is taken instead.
            bool isNearX = Math.Abs(axis.X) > 0.7;
            across = Vector3D.Cross(axis, isNearX ? Vector3D.UnitY : Vector3D.UnitX);
        }

        Vector3D unit = across.Normalized();
        return (unit - (Vector3D.Dot(unit, axis) * axis)).Normalized();
    }
}

/// <summary>The Sun as a light source that casts shadows.</summary>
/// <param name="PositionBodyFixed">The Sun's centre, m, body-fixed.</param>
/// <param name="Slope">Radius of the Sun's disc over its distance from the Moon's centre; 0 for a point source.</param>
internal readonly record struct LightSource(Vector3D PositionBodyFixed, double Slope);
