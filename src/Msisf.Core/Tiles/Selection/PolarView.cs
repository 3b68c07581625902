using Msisf.Core.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>
/// The Moon in half planes about the axis from its centre to a viewpoint (the camera or the Sun). In such a half plane the surface is a
/// profile with one radius for each angle from the axis, and a ray from the viewpoint has one slope: metres along the axis over metres
/// across. The ray is under the surface at an angle exactly when the profile's slope there is greater (docs/tile-selection.md).
/// </summary>
internal sealed class PolarView
{
    private readonly Vector3D _east;
    private readonly Vector3D _north;

    /// <param name="viewpointMoonMe">m, MOON_ME; not the centre.</param>
    public PolarView(Vector3D viewpointMoonMe)
    {
        Distance = viewpointMoonMe.Length;
        Axis = viewpointMoonMe.Normalized();
        Vector3D helper = Math.Abs(Axis.Z) < 0.9 ? Vector3D.UnitZ : Vector3D.UnitX;
        _east = Vector3D.Cross(helper, Axis).Normalized();
        _north = Vector3D.Cross(Axis, _east);
    }

    /// <summary>From the Moon's centre to the viewpoint, length 1, MOON_ME.</summary>
    public Vector3D Axis { get; }

    /// <summary>Distance of the viewpoint from the Moon's centre, m.</summary>
    public double Distance { get; }

    /// <summary>Slope of the line of sight to a point.</summary>
    /// <param name="radius">Distance of the point from the Moon's centre, m.</param>
    /// <param name="cos">Cosine of the angle from the axis.</param>
    /// <param name="sin">Sine of the angle, above 0.</param>
    public double Slope(double radius, double cos, double sin) => ((radius * cos) - Distance) / (radius * sin);

    /// <summary>Slope of the ray that touches a sphere below the viewpoint.</summary>
    public double TangentSlope(double radius) => -Math.Sqrt((Distance - radius) * (Distance + radius)) / radius;

    /// <summary>Azimuth of a direction, rad in (-pi, pi].</summary>
    public double AzimuthOf(Vector3D direction) => Math.Atan2(Vector3D.Dot(direction, _north), Vector3D.Dot(direction, _east));

    /// <summary>Places a point.</summary>
    /// <param name="position">m, MOON_ME.</param>
    public PolarPoint Project(Vector3D position)
    {
        double along = Vector3D.Dot(position, Axis);
        double east = Vector3D.Dot(position, _east);
        double north = Vector3D.Dot(position, _north);
        double radius = Math.Sqrt((along * along) + (east * east) + (north * north)); // lunar radii: neither overflow nor underflow
        double arc = Math.Sqrt(Math.Max(0.0, 0.5 * (1.0 - (along / radius))));
        return new PolarPoint(east, north, along - Distance, arc, Math.Atan2(north, east));
    }

    /// <summary>Bounds of a node's points.</summary>
    public PolarBounds Bounds(in TerrainNode node)
    {
        SphericalCap cap = node.Cap;
        double cos = Vector3D.Dot(cap.Centre, Axis);
        double east = Vector3D.Dot(cap.Centre, _east);
        double north = Vector3D.Dot(cap.Centre, _north);
        double sin = Math.Sqrt((east * east) + (north * north));
        double sinNear = (sin * cap.CosRadius) - (cos * cap.SinRadius);
        double sinFar = (sin * cap.CosRadius) + (cos * cap.SinRadius);
        if (!(sinNear > 0.0) || !(sinFar > 0.0))
        {
            return BoundsOnAxis(node, cos, sinNear, sin);
        }

        double cosNear = (cos * cap.CosRadius) + (sin * cap.SinRadius);
        double cosFar = (cos * cap.CosRadius) - (sin * cap.SinRadius);
        double min = Math.Min(Slope(node.MinRadius, cosNear, sinNear), Slope(node.MinRadius, cosFar, sinFar));
        double half = cap.SinRadius / sin; // below 1, as the cap does not reach the axis
        return new PolarBounds(
            Arc(cosNear),
            Arc(cosFar),
            Math.Atan2(north, east),
            Math.Atan2(half, Math.Sqrt((1.0 - half) * (1.0 + half))),
            min,
            MaxSlope(node.MaxRadius, cosNear, sinNear, cosFar, sinFar));
    }

    /// <summary>Sine of half an angle from its cosine.</summary>
    public static double Arc(double cos) => Math.Sqrt(Math.Max(0.0, 0.5 * (1.0 - cos)));

    /// <summary>
    /// On a sphere the slope increases with the angle up to the tangent ray and decreases beyond it; on a sphere above the viewpoint it
    /// always decreases.
    /// </summary>
    private double MaxSlope(double radius, double cosNear, double sinNear, double cosFar, double sinFar)
    {
        double cosTangent = Math.Min(1.0, radius / Distance);
        if (cosNear <= cosTangent)
        {
            return Slope(radius, cosNear, sinNear);
        }

        return cosFar >= cosTangent ? Slope(radius, cosFar, sinFar) : TangentSlope(radius);
    }

    private PolarBounds BoundsOnAxis(in TerrainNode node, double cos, double sinNear, double sin)
    {
        SphericalCap cap = node.Cap;
        bool holdsNearPole = !(sinNear > 0.0) && (cos > 0.0 || cap.CosRadius <= 0.0);
        double cosNear = holdsNearPole ? 1.0 : (cos * cap.CosRadius) + (sin * cap.SinRadius);
        bool holdsFarPole = !((sin * cap.CosRadius) + (cos * cap.SinRadius) > 0.0);
        double cosFar = holdsFarPole ? -1.0 : (cos * cap.CosRadius) - (sin * cap.SinRadius);
        double sinFar = (sin * cap.CosRadius) + (cos * cap.SinRadius);
        double max;
        if (holdsNearPole && node.MaxRadius >= Distance)
        {
            max = double.PositiveInfinity;
        }
        else if (holdsNearPole)
        {
            double cosTangent = node.MaxRadius / Distance;
            max = !holdsFarPole && cosFar >= cosTangent
                ? Slope(node.MaxRadius, cosFar, sinFar)
                : TangentSlope(node.MaxRadius);
        }
        else
        {
            max = cosNear <= Math.Min(1.0, node.MaxRadius / Distance)
                ? Slope(node.MaxRadius, cosNear, Math.Max(sinNear, double.Epsilon))
                : TangentSlope(node.MaxRadius);
        }

        return new PolarBounds(Arc(cosNear), Arc(cosFar), 0.0, 2.0 * Math.PI, double.NegativeInfinity, max);
    }
}
