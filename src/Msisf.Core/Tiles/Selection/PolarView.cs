using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>A point in the half planes of a <see cref="PolarView"/>.</summary>
/// <param name="East">m across the axis.</param>
/// <param name="North">m across the axis, at right angles to <paramref name="East"/>.</param>
/// <param name="Rise">m along the axis, over the viewpoint.</param>
/// <param name="Arc">Sine of half the angle from the axis at the Moon's centre; it increases along each ray from the viewpoint.</param>
/// <param name="Azimuth">rad in (-pi, pi].</param>
internal readonly record struct PolarPoint(double East, double North, double Rise, double Arc, double Azimuth)
{
    /// <summary>Distance from the axis, m.</summary>
    public double Across => Math.Sqrt((East * East) + (North * North));
}

/// <summary>
/// The Moon in half planes about the axis from its centre to a viewpoint (the camera or the Sun). In such a half plane the surface is a
/// profile with one radius for each angle from the axis, and a ray from the viewpoint has one slope: metres along the axis over metres
/// across. The ray is under the surface at an angle exactly when the profile's slope there is greater (docs/surface.md).
/// </summary>
internal sealed class PolarView
{
    private readonly Vector3D _east;
    private readonly Vector3D _north;

    /// <param name="viewpointBodyFixed">m, body-fixed; not the centre.</param>
    public PolarView(Vector3D viewpointBodyFixed)
    {
        Distance = viewpointBodyFixed.Length;
        Axis = viewpointBodyFixed.Normalized();
        Vector3D helper = Math.Abs(Axis.Z) < 0.9 ? Vector3D.UnitZ : Vector3D.UnitX;
        _east = Vector3D.Cross(helper, Axis).Normalized();
        _north = Vector3D.Cross(Axis, _east);
    }

    /// <summary>From the Moon's centre to the viewpoint, length 1, body-fixed.</summary>
    public Vector3D Axis { get; }

    /// <summary>Distance of the viewpoint from the Moon's centre, m.</summary>
    public double Distance { get; }

    /// <summary>Slope of the ray that touches a sphere below the viewpoint.</summary>
    public double TangentSlope(double radius) => -Math.Sqrt((Distance - radius) * (Distance + radius)) / radius;

    /// <summary>Azimuth of a direction, rad in (-pi, pi].</summary>
    public double AzimuthOf(Vector3D direction) => Math.Atan2(Vector3D.Dot(direction, _north), Vector3D.Dot(direction, _east));

    /// <summary>Places a point.</summary>
    /// <param name="position">m, body-fixed.</param>
    public PolarPoint Project(Vector3D position)
    {
        double along = Vector3D.Dot(position, Axis);
        double east = Vector3D.Dot(position, _east);
        double north = Vector3D.Dot(position, _north);
        double radius = Math.Sqrt((along * along) + (east * east) + (north * north)); // lunar radii: neither overflow nor underflow
        return new PolarPoint(east, north, along - Distance, Arc(along / radius), Math.Atan2(north, east));
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
        double cosNear = (cos * cap.CosRadius) + (sin * cap.SinRadius);
        double cosFar = (cos * cap.CosRadius) - (sin * cap.SinRadius);
        double max = MaxSlope(node.MaxRadius, cosNear, sinNear, cosFar, sinFar);
        if (sinNear > 0.0 && sinFar > 0.0)
        {
            double min = Math.Min(Slope(node.MinRadius, cosNear, sinNear), Slope(node.MinRadius, cosFar, sinFar));
            double half = cap.SinRadius / sin; // below 1, as the cap does not reach the axis
            double halfWidth = Math.Atan2(half, Math.Sqrt((1.0 - half) * (1.0 + half)));
            return new PolarBounds(Arc(cosNear), Arc(cosFar), Math.Atan2(north, east), halfWidth, min, max);
        }

        // The cap holds one end of the axis, or both.
        bool holdsNearPole = !(sinNear > 0.0) && (cos > 0.0 || cap.CosRadius <= 0.0);
        bool holdsFarPole = !(sinFar > 0.0);
        if (holdsNearPole)
        {
            max = node.MaxRadius >= Distance ? double.PositiveInfinity
                : !holdsFarPole && cosFar >= node.MaxRadius / Distance ? Slope(node.MaxRadius, cosFar, sinFar)
                : TangentSlope(node.MaxRadius);
        }
        else
        {
            max = cosNear <= Math.Min(1.0, node.MaxRadius / Distance)
                ? Slope(node.MaxRadius, cosNear, Math.Max(sinNear, double.Epsilon))
                : TangentSlope(node.MaxRadius);
        }

        return new PolarBounds(
            holdsNearPole ? 0.0 : Arc(cosNear), holdsFarPole ? 1.0 : Arc(cosFar), 0.0, 2.0 * Math.PI, double.NegativeInfinity, max);
    }

    /// <summary>Bounds of a polygon; their azimuths are the whole circle if it may meet the axis.</summary>
    /// <param name="polygon">Its corners, m, body-fixed.</param>
    public PolarBounds Bounds(ReadOnlySpan<Vector3D> polygon)
    {
        PolarPoint first = Project(polygon[0]);
        (double near, double far) = (first.Arc, first.Arc);
        (double min, double max) = (double.PositiveInfinity, double.NegativeInfinity);
        (double lowest, double highest) = (0.0, 0.0);
        double nearest = double.PositiveInfinity;
        foreach (Vector3D corner in polygon)
        {
            PolarPoint point = Project(corner);
            double across = point.Across;
            double slope = point.Rise / across;
            double margin = Tolerances.VertexLattice * (1.0 + Math.Abs(slope)) / across;
            double turn = AzimuthWindow.Wrapped(point.Azimuth - first.Azimuth);
            nearest = Math.Min(nearest, across);
            (near, far) = (Math.Min(near, point.Arc), Math.Max(far, point.Arc));
            (min, max) = (Math.Min(min, slope - margin), Math.Max(max, slope + margin));
            (lowest, highest) = (Math.Min(lowest, turn), Math.Max(highest, turn));
        }

        double half = 0.5 * (highest - lowest);
        double reach = half + (Tolerances.VertexLattice / nearest);
        double size = Math.Sqrt(
            (polygon[0] - polygon[^1]).LengthSquared + (polygon[0] - polygon[1]).LengthSquared + (polygon[0] - polygon[2]).LengthSquared);
        if (!(reach < 0.25 * Math.PI) || nearest < 3.0 * size)
        {
            // The polygon is so near to the axis that it may enclose it, or that its edges are much nearer to it than its corners.
            return new PolarBounds(
                0.0, Math.Min(1.0, far + Tolerances.CapRadius), 0.0, 2.0 * Math.PI, double.NegativeInfinity, double.PositiveInfinity);
        }

        // Between two corners a chord is nearer to the axis than both, by the cosine of half the turn at most; its arcs by far less than
        // the turn squared.
        double chord = 1.0 / Math.Cos(half);
        double bulge = half * half;
        return new PolarBounds(
            near * (1.0 - bulge),
            Math.Min(1.0, far * (1.0 + bulge)),
            first.Azimuth + (0.5 * (lowest + highest)),
            reach,
            min < 0.0 ? min * chord : min,
            max > 0.0 ? max * chord : max);
    }

    /// <summary>Sine of half an angle from its cosine.</summary>
    public static double Arc(double cos) => Math.Sqrt(Math.Max(0.0, 0.5 * (1.0 - cos)));

    /// <summary>Slope of the line of sight to a point at an angle from the axis.</summary>
    private double Slope(double radius, double cos, double sin) => ((radius * cos) - Distance) / (radius * sin);

    /// <summary>
    /// On a sphere the slope increases with the angle up to the tangent ray and decreases beyond it; on a sphere above the viewpoint it
    /// always decreases.
    /// </summary>
    private double MaxSlope(double radius, double cosNear, double sinNear, double cosFar, double sinFar)
    {
        double cosTangent = Math.Min(1.0, radius / Distance);
        return cosNear <= cosTangent ? Slope(radius, cosNear, sinNear)
            : cosFar >= cosTangent ? Slope(radius, cosFar, sinFar)
            : TangentSlope(radius);
    }
}

/// <summary>Where a piece of the surface can lie in the half planes of a <see cref="PolarView"/>.</summary>
/// <param name="Near">Minimum <see cref="PolarPoint.Arc"/>.</param>
/// <param name="Far">Maximum arc.</param>
/// <param name="Azimuth">Azimuth of the middle, rad.</param>
/// <param name="HalfWidth">Half of the range of azimuths, rad; pi or more is the whole circle.</param>
/// <param name="MinSlope">Minimum slope of the lines of sight to the piece.</param>
/// <param name="MaxSlope">Maximum slope of the lines of sight to the piece.</param>
internal readonly record struct PolarBounds(
    double Near, double Far, double Azimuth, double HalfWidth, double MinSlope, double MaxSlope)
{
    /// <summary>
    /// The bounds of the piece if it is seen higher by a small angle: slopes are cotangents of the angle from the axis.
    /// </summary>
    /// <param name="angle">rad.</param>
    public PolarBounds Raised(double angle) => this with { MaxSlope = MaxSlope + (angle * (1.0 + (MaxSlope * MaxSlope))) };

    /// <summary>Whether one ray from the viewpoint can meet both.</summary>
    public bool CanShareRayWith(in PolarBounds other)
    {
        if (MinSlope > other.MaxSlope || other.MinSlope > MaxSlope)
        {
            return false;
        }

        double apart = Math.Abs(Azimuth - other.Azimuth);
        return Math.Min(apart, (2.0 * Math.PI) - apart) <= HalfWidth + other.HalfWidth;
    }
}
