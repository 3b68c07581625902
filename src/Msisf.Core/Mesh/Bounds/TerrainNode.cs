using Msisf.Core.Numerics;

namespace Msisf.Core.Mesh.Bounds;

/// <summary>A piece of the surface with bounds that are known without reading its samples.</summary>
/// <param name="Cap">Cap that contains the directions of all points of the piece.</param>
/// <param name="MinRadius">m: minimum radius of the facets.</param>
/// <param name="MaxRadius">m: maximum radius of the facets.</param>
/// <param name="MaxSlope">Upper bound of the tangent of the facets' slopes.</param>
internal readonly record struct TerrainNode(SphericalCap Cap, double MinRadius, double MaxRadius, double MaxSlope)
{
    /// <summary>A ball that contains the piece: its centre (m, MOON_ME) and radius (m).</summary>
    public (Vector3D Centre, double Radius) Ball()
    {
        double middle = 0.5 * (MinRadius + MaxRadius) * Cap.CosRadius;
        return (middle * Cap.Centre, Math.Max(ToRim(middle, MinRadius), ToRim(middle, MaxRadius)));
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
