using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;

namespace Msisf.Core.Tests.Render.Shadows;

/// <summary>A point of the surface, m, and its facet.</summary>
internal readonly record struct SurfacePoint(Vector3D Position, BruteForceMoon.FacetId Facet);

/// <summary>Random points of the surface, and Suns over it; angles in degrees.</summary>
internal static class SurfacePoints
{
    /// <summary>
    /// A ray that rises less than this out of its facet may meet it again beyond the millimetre that the brute force leaves out.
    /// </summary>
    public const double MinCosine = 1e-4;

    private const double SunDistance = 1.496e11; // m

    /// <summary>Unit vector to a place.</summary>
    public static Vector3D Direction(double latitude, double longitude) =>
        new SelenographicPoint(latitude * Math.PI / 180.0, longitude * Math.PI / 180.0).ToDirectionBodyFixed();

    /// <summary>The Sun over a place.</summary>
    /// <param name="up">The place.</param>
    /// <param name="elevation">Over its horizontal plane.</param>
    /// <param name="azimuth">From any direction of the plane.</param>
    public static Vector3D Sun(Vector3D up, double elevation, double azimuth)
    {
        Vector3D side = Vector3D.Cross(up, Math.Abs(up.X) < 0.7 ? Vector3D.UnitX : Vector3D.UnitZ).Normalized();
        Vector3D other = Vector3D.Cross(up, side);
        (double sinAzimuth, double cosAzimuth) = Math.SinCos(azimuth * Math.PI / 180.0);
        (double sinElevation, double cosElevation) = Math.SinCos(elevation * Math.PI / 180.0);
        return SunDistance * ((sinElevation * up) + (cosElevation * ((cosAzimuth * side) + (sinAzimuth * other))));
    }

    /// <summary>Random directions around a place, about so far.</summary>
    public static IEnumerable<Vector3D> Around(Vector3D middle, double radius, int count, Random random) =>
        Enumerable.Range(0, count).Select(_ => (middle + ((2.0 * Math.Sin(0.5 * radius * Math.PI / 180.0))
            * new Vector3D(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5))).Normalized());

    /// <summary>Points around a place whose facets face the Sun.</summary>
    /// <param name="moon">The surface.</param>
    /// <param name="middle">The place.</param>
    /// <param name="radius">How far around, about; below 180.</param>
    /// <param name="sun">m.</param>
    /// <param name="count">How many, or fewer if so much as twenty times that many do not face the Sun.</param>
    /// <param name="random">Gives the places.</param>
    /// <param name="minCosine">Of the incidence angle.</param>
    public static List<SurfacePoint> Facing(
        BruteForceMoon moon, Vector3D middle, double radius, Vector3D sun, int count, Random random, double minCosine = MinCosine)
    {
        List<SurfacePoint> points = [];
        foreach (Vector3D direction in Around(middle, radius, 20 * count, random).TakeWhile(_ => points.Count < count))
        {
            (BruteForceMoon.FacetId facet, double t) = moon.FirstHit(4e6 * direction, -direction)!.Value;
            Vector3D point = (4e6 - t) * direction;
            if (Vector3D.Dot(moon.Normal(facet), (sun - point).Normalized()) > minCosine)
            {
                points.Add(new SurfacePoint(point, facet));
            }
        }

        return points;
    }
}
