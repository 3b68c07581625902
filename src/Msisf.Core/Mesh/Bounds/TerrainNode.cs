using Msisf.Core.Numerics;

namespace Msisf.Core.Mesh.Bounds;

/// <summary>A piece of the surface and what is known of it without reading it.</summary>
/// <param name="Cap">Holds the direction of each of its points.</param>
/// <param name="MinRadius">m: no point of a facet lies lower.</param>
/// <param name="MaxRadius">m: no point lies higher.</param>
/// <param name="MaxSlope">Tangent of an angle that no facet's slope exceeds.</param>
internal readonly record struct TerrainNode(SphericalCap Cap, double MinRadius, double MaxRadius, double MaxSlope)
{
    /// <summary>A ball that holds the piece: its middle (m, MOON_ME) and radius (m).</summary>
    public (Vector3D Centre, double Radius) Ball()
    {
        double middle = 0.5 * (MinRadius + MaxRadius) * Cap.CosRadius;
        return (middle * Cap.Centre, Math.Max(ToRim(middle, MinRadius), ToRim(middle, MaxRadius)));
    }

    /// <summary>
    /// Distance from the point at height <paramref name="middle"/> on the cap's axis to the rim at a radius; the farthest at that radius.
    /// </summary>
    private double ToRim(double middle, double radius)
    {
        double along = (radius * Cap.CosRadius) - middle;
        double across = radius * Cap.SinRadius;
        double rim = Math.Sqrt((along * along) + (across * across)); // lunar radii
        return Math.Max(rim, Math.Abs(radius - middle));
    }
}
