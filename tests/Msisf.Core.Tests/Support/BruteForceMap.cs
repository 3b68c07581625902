using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tests.Support;

/// <summary>
/// Rays against each facet of a polar map, by Moeller and Trumbore. A facet is met from its upper side only. Shares nothing with the
/// program but the rule for cells, which it writes out for itself; directions are computed from latitude and longitude.
/// </summary>
internal sealed class BruteForceMap
{
    private const double EdgeTolerance = 1e-11;

    private readonly Vector3D[,] _vertices;

    public BruteForceMap(ITerrainGrid grid)
    {
        PolarStereographic map = (PolarStereographic)grid.Projection;
        double steps = Math.Pow(2.0, Math.Max(7.0, Math.Ceiling(Math.Log2(2048.0 / map.MetresPerPixel))));
        _vertices = new Vector3D[grid.Lines, grid.Samples];
        double[] radii = new double[grid.Samples];
        for (int line = 0; line < grid.Lines; line++)
        {
            grid.ReadRadii(line, 0, radii);
            for (int sample = 0; sample < grid.Samples; sample++)
            {
                double x = (sample - map.SampleOffset) * map.MetresPerPixel;
                double y = (map.IsSouth ? map.LineOffset - line : line - map.LineOffset) * map.MetresPerPixel;
                double latitude = (0.5 * Math.PI) - (2.0 * Math.Atan(Math.Sqrt((x * x) + (y * y)) / 2.0 / 1_737_400.0));
                double longitude = Math.Atan2(x, y);
                Vector3D direction = new SelenographicPoint(map.IsSouth ? -latitude : latitude, longitude).ToDirectionBodyFixed();
                Vector3D v = steps * radii[sample] * direction;
                _vertices[line, sample] = new Vector3D(Math.Round(v.X) / steps, Math.Round(v.Y) / steps, Math.Round(v.Z) / steps);
            }
        }
    }

    /// <summary>A vertex, m.</summary>
    public Vector3D this[int line, int sample] => _vertices[line, sample];

    /// <summary>Whether all facets of a vertex and of those to its right and below face a position.</summary>
    public bool FacesAround(int line, int sample, Vector3D position)
    {
        for (int cell = 0; cell < 9; cell++)
        {
            foreach (FacetHalf half in new[] { FacetHalf.SouthWest, FacetHalf.NorthEast })
            {
                (Vector3D a, Vector3D b, Vector3D c) = Corners(line - 1 + (cell / 3), sample - 1 + (cell % 3), half);
                if (!(Vector3D.Dot(Vector3D.Cross(b - a, c - a), position - a) > 0.0))
                {
                    return false;
                }
            }
        }

        return true;
    }

    /// <summary>The first facet that a ray enters.</summary>
    /// <param name="origin">m.</param>
    /// <param name="direction">Any length.</param>
    /// <param name="minT">Hits before this many lengths of the direction do not count.</param>
    public (FacetId Facet, Vector3D Point, double T)? FirstHit(Vector3D origin, Vector3D direction, double minT = 0.0)
    {
        (FacetId, Vector3D, double T)? best = null;
        for (int line = 0; line + 1 < _vertices.GetLength(0); line++)
        {
            for (int sample = 0; sample + 1 < _vertices.GetLength(1); sample++)
            {
                foreach (FacetHalf half in new[] { FacetHalf.SouthWest, FacetHalf.NorthEast })
                {
                    (Vector3D a, Vector3D b, Vector3D c) = Corners(line, sample, half);
                    if (HitOf(origin, direction, a, b, c) is double t && t >= minT && !(t >= best?.T))
                    {
                        best = (new FacetId(line, sample, half), origin + (t * direction), t);
                    }
                }
            }
        }

        return best;
    }

    /// <summary>Whether a point on a facet gets no light: the facet faces away, or the way to the light enters another.</summary>
    public bool IsShadowed(FacetId facet, Vector3D point, Vector3D light)
    {
        (Vector3D a, Vector3D b, Vector3D c) = Corners(facet.Line, facet.Sample, facet.Half);
        Vector3D toLight = light - point;
        return Vector3D.Dot(Vector3D.Cross(b - a, c - a), toLight) <= 0.0
            || (FirstHit(point, toLight, 1e-4 / toLight.Length) is (FacetId hit, _, double t) && t < 1.0 && hit != facet);
    }

    private (Vector3D A, Vector3D B, Vector3D C) Corners(int line, int sample, FacetHalf half) => half == FacetHalf.SouthWest
        ? (_vertices[line, sample], _vertices[line + 1, sample], _vertices[line + 1, sample + 1])
        : (_vertices[line, sample], _vertices[line + 1, sample + 1], _vertices[line, sample + 1]);

    private static double? HitOf(Vector3D origin, Vector3D direction, Vector3D a, Vector3D b, Vector3D c)
    {
        Vector3D ab = b - a;
        Vector3D ac = c - a;
        Vector3D p = Vector3D.Cross(direction, ac);
        double determinant = Vector3D.Dot(ab, p);
        if (!(determinant > 0.0))
        {
            return null; // from below, or edge on
        }

        Vector3D fromA = origin - a;
        double u = Vector3D.Dot(fromA, p) / determinant;
        Vector3D q = Vector3D.Cross(fromA, ab);
        double v = Vector3D.Dot(direction, q) / determinant;
        return u >= -EdgeTolerance && v >= -EdgeTolerance && u + v <= 1.0 + EdgeTolerance ? Vector3D.Dot(ac, q) / determinant : null;
    }
}
