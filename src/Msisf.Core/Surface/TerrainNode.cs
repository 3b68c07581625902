namespace Msisf.Core.Surface;

/// <summary>A piece of the surface with bounds that are known without reading its samples.</summary>
/// <param name="Cap">Cap that contains the directions of all points of the piece.</param>
/// <param name="MinRadius">m: minimum radius of the facets.</param>
/// <param name="MaxRadius">m: maximum radius of the facets.</param>
/// <param name="MaxSlope">Upper bound of the tangent of the facets' slopes.</param>
internal readonly record struct TerrainNode(SphericalCap Cap, double MinRadius, double MaxRadius, double MaxSlope)
{
    /// <summary>Whether the piece was not read: its radii are the limits of the model, its slope is unlimited.</summary>
    public bool IsUnread { get; init; }

    /// <summary>A ball that contains the piece: its centre (m, MOON_ME) and radius (m).</summary>
    /// <remarks>
    /// The ball of an unread piece also contains the ball that the piece has when it is read: the centres are at most half the range of
    /// radii apart, and so the other ball reaches at most that range beyond this one.
    /// </remarks>
    public (Vector3D Centre, double Radius) Ball()
    {
        double middle = 0.5 * (MinRadius + MaxRadius) * Cap.CosRadius;
        double radius = Math.Max(ToRim(middle, MinRadius), ToRim(middle, MaxRadius));
        return (middle * Cap.Centre, IsUnread ? radius + (MaxRadius - MinRadius) : radius);
    }

    /// <summary>
    /// Maximum distance (m) of the cap's points at a radius from the point of the cap's axis that is <paramref name="middle"/> from the
    /// Moon's centre.
    /// </summary>
    private double ToRim(double middle, double radius)
    {
        double along = (radius * Cap.CosRadius) - middle;
        double across = radius * Cap.SinRadius;
        double rim = Math.Sqrt((along * along) + (across * across)); // lunar radii
        return Math.Max(rim, Math.Abs(radius - middle));
    }
}
