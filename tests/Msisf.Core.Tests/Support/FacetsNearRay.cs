using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tests.Support;

/// <summary>
/// Rays against all facets that come near them, at any resolution: goes along the ray in steps of a cell and tests each cell around, by
/// Moeller and Trumbore. Shares with the program the lattice of the vertices only; nothing of the surface is kept.
/// </summary>
internal sealed class FacetsNearRay
{
    /// <summary>m: an origin farther away is moved along the ray; relative to it facets would be known to 1e-7 m only.</summary>
    private const double FarAway = 1e8;

    private readonly LatticeVertices _vertices;
    private readonly double _lowest;
    private readonly double _highest;

    /// <param name="grid">The model.</param>
    /// <param name="relief">m: no height is farther from the reference radius.</param>
    public FacetsNearRay(IGlobalGrid grid, double relief)
    {
        _vertices = new LatticeVertices(grid);
        _lowest = (1_737_400.0 - relief - 1.0) * Math.Cos(Math.PI / _vertices.Lines);
        _highest = 1_737_400.0 + relief + 1.0;
    }

    /// <summary>The first facet on a ray from outside the ground.</summary>
    /// <param name="origin">m.</param>
    /// <param name="direction">Any length.</param>
    /// <param name="minT">Hits before this many lengths of the direction do not count.</param>
    public (FacetId Facet, Vector3D Point, double T)? FirstHit(Vector3D origin, Vector3D direction, double minT = 0.0)
    {
        double offset = origin.Length < FarAway ? 0.0 : (origin.Length - 1e7) / direction.Length;
        Vector3D near = new(
            Moved(origin.X, offset, direction.X), Moved(origin.Y, offset, direction.Y), Moved(origin.Z, offset, direction.Z));
        FacetSearch search = new(_vertices, near, direction, minT - offset);
        double length = direction.Length;
        Vector3D unit = direction / length;
        double nearest = -Vector3D.Dot(near, unit);
        double distance = (near + (nearest * unit)).Length;
        if (distance > _highest)
        {
            return null;
        }

        double half = Math.Sqrt((_highest - distance) * (_highest + distance));
        double step = 1_737_400.0 * Math.PI / _vertices.Lines;
        for (double s = Math.Max(nearest - half, 0.0) - step; s < nearest + half + step && s <= search.T * length; s += step)
        {
            Vector3D from = near + (s * unit);
            Vector3D to = near + ((s + step) * unit);
            if (from.Length < _lowest && to.Length < _lowest)
            {
                break;
            }

            search.TestBetween(from, to);
        }

        return search.Facet is FacetId facet ? (facet, near + (search.T * direction), offset + search.T) : null;
    }

    /// <summary>Whether a point on a facet gets no light: the facet faces away, or anything is in between.</summary>
    public bool IsShadowed(FacetId facet, Vector3D point, Vector3D light)
    {
        Vector3D toLight = light - point;
        if (Vector3D.Dot(_vertices.NormalOf(facet), toLight) <= 0.0)
        {
            return true;
        }

        // 1 mm off the surface: the point itself is rounded to some 1e-9 m.
        return FirstHit(point, toLight, 1e-3 / toLight.Length) is (FacetId hit, _, double t) && t < 1.0 && hit != facet;
    }

    /// <summary>origin + factor direction with one rounding at the end: the low parts of product and sum are exact.</summary>
    private static double Moved(double origin, double factor, double direction)
    {
        double product = factor * direction;
        double sum = origin + product;
        double added = sum - origin;
        return sum + ((origin - (sum - added)) + (product - added) + Math.FusedMultiplyAdd(factor, direction, -product));
    }
}
