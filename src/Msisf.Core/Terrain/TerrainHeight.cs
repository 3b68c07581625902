using System.Globalization;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;

namespace Msisf.Core.Terrain;

/// <summary>Where the surface of the mesh is, exactly: on its facets, not on a sphere.</summary>
public static class TerrainHeight
{
    /// <summary>Parts of a facet by which a radial line may miss it and still be counted to it: rounding at an edge.</summary>
    private const double EdgeTolerance = 1e-9;

    /// <summary>Distance from the Moon's centre to the facet below (or above) a position.</summary>
    /// <param name="grid">The model.</param>
    /// <param name="positionMoonMe">m, MOON_ME; not the centre.</param>
    /// <returns>m.</returns>
    /// <exception cref="BadInputException">The position is the centre or not finite.</exception>
    public static double RadiusBelow(IElevationGrid grid, Vector3D positionMoonMe)
    {
        Vector3D direction = positionMoonMe.Normalized();
        FacetMesh mesh = new(grid);
        SelenographicPoint point = SelenographicPoint.Below(direction);
        int line = (int)Math.Floor(((0.5 - (point.Latitude / Math.PI)) * mesh.Lines) - 0.5);
        int sample = (int)Math.Floor((point.Longitude / (2.0 * Math.PI) * mesh.Samples) - 0.5);

        // Straight edges bulge over their parallel, so the facet can be one of the cells around.
        TerrainPatch patch = new(mesh);
        patch.Load(new CellRange(
            Math.Clamp(line - 1, -1, mesh.Lines - 1), Math.Clamp(line + 2, 0, mesh.Lines), sample - 1, sample + 2));
        double nearest = double.NegativeInfinity;
        double radius = double.NaN;
        for (int row = 0; row + 1 < patch.Lines; row++)
        {
            for (int column = 0; column + 1 < patch.Samples; column++)
            {
                Vector3D northWest = patch[row, column];
                Vector3D southEast = patch[row + 1, column + 1];
                Try(direction, northWest, patch[row + 1, column], southEast, ref nearest, ref radius);
                Try(direction, northWest, southEast, patch[row, column + 1], ref nearest, ref radius);
            }
        }

        return nearest >= -EdgeTolerance
            ? radius
            : throw new InvalidOperationException($"No facet below {positionMoonMe}.");
    }

    /// <summary>Refuses a position inside the Moon.</summary>
    /// <param name="grid">The model.</param>
    /// <param name="positionMoonMe">m, MOON_ME.</param>
    /// <exception cref="BadInputException">The position is not above the surface.</exception>
    public static void RequireAbove(IElevationGrid grid, Vector3D positionMoonMe)
    {
        double distance = positionMoonMe.Length;
        double surface = distance > 0.0 ? RadiusBelow(grid, positionMoonMe) : double.PositiveInfinity;
        if (!(distance > surface + Tolerances.VertexLattice))
        {
            throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture,
                $"The camera is inside the Moon: {distance:R} m from its centre, where the surface of {grid.ProductId} is at {surface:R} m. Move it up."));
        }
    }

    /// <summary>Intersects the line from the centre with one facet; of several the one that is met farthest inside counts.</summary>
    private static void Try(Vector3D direction, Vector3D a, Vector3D b, Vector3D c, ref double nearest, ref double radius)
    {
        double u = Vector3D.Dot(direction, Vector3D.Cross(b, c));
        double v = Vector3D.Dot(direction, Vector3D.Cross(c, a));
        double w = Vector3D.Dot(direction, Vector3D.Cross(a, b));
        double sum = u + v + w;
        if (!(sum > 0.0))
        {
            return; // the second facet of a polar cell has no area
        }

        double inside = Math.Min(u, Math.Min(v, w)) / sum;
        if (inside > nearest)
        {
            nearest = inside;
            radius = Vector3D.Dot(a, Vector3D.Cross(b - a, c - a)) / Vector3D.Dot(direction, Vector3D.Cross(b - a, c - a));
        }
    }
}
