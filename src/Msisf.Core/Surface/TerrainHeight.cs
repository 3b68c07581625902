using Msisf.Core.Terrain;

namespace Msisf.Core.Surface;

/// <summary>Computes the exact radius of the surface of the mesh, on its facets and not on a sphere.</summary>
public static class TerrainHeight
{
    /// <summary>
    /// m: a facet with a shorter edge has no area: those at a pole, and at 1024 px/deg those beside it, whose edges of 2e-4 m vanish on the
    /// lattice. Below the steps of all lattices.
    /// </summary>
    private const double ShortestEdge = 1e-6;

    /// <summary>A direction with larger weights of all corners of a facet lies in no other; far above their rounding.</summary>
    private const double WellInside = 1e-6;

    /// <summary>
    /// Distance from the Moon's centre to the facet below (or above) a position; outside a map of a part of the Moon that to the reference
    /// sphere.
    /// </summary>
    /// <param name="terrain">The model, or several.</param>
    /// <param name="positionBodyFixed">m, body-fixed; not the centre.</param>
    /// <returns>m.</returns>
    /// <exception cref="BadInputException">The position is the centre or not finite.</exception>
    public static double RadiusBelow(ITerrain terrain, Vector3D positionBodyFixed)
    {
        Vector3D direction = positionBodyFixed.Normalized();
        return terrain is IGround ground
            ? ground.RadiusAt(direction)
            : RadiusOn(new FacetMesh((ITerrainGrid)terrain), direction) ?? terrain.ReferenceRadius;
    }

    /// <summary>Distance from the Moon's centre to the facet of a mesh in a direction, m; null outside a map.</summary>
    /// <param name="direction">Unit vector, body-fixed.</param>
    internal static double? RadiusOn(FacetMesh mesh, Vector3D direction)
    {
        if (CellsAround(mesh, direction) is not { } cells)
        {
            return null;
        }

        // Nearly always the direction lies well within the cell in the middle.
        bool hasMiddle = cells is { Lines: 3, Samples: 3 };
        CellRange middle = new(cells.FirstLine + 1, cells.FirstLine + 2, cells.FirstSample + 1, cells.FirstSample + 2);
        if (hasMiddle && RadiusIn(mesh, middle, direction) is (double within, > WellInside))
        {
            return within;
        }

        (double radius, _) = RadiusIn(mesh, cells, direction);
        return double.IsFinite(radius)
            ? radius
            : throw new InvalidOperationException($"No facet in direction {direction}.");
    }

    /// <summary>Radius of the facet of some cells that holds a direction best, and the least weight of its corners there.</summary>
    private static (double Radius, double Inside) RadiusIn(FacetMesh mesh, CellRange cells, Vector3D direction)
    {
        TerrainPatch patch = new(mesh);
        patch.Load(cells);
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

        return (radius, nearest);
    }

    /// <summary>
    /// Distance from the Moon's centre to the facet of a surface of several models, m. The seams are needed only where no model has it well
    /// inside one of its cells. Null beside the facets of a surface that is not closed.
    /// </summary>
    internal static double? RadiusOn(IReadOnlyList<GridPatch> parts, Func<SeamPatch> seamsOf, Vector3D direction)
    {
        double nearest = double.NegativeInfinity;
        double radius = double.NaN;
        foreach (GridPatch part in parts.Where(part => !part.IsLeftOut))
        {
            CellRange cells = CellsAround(part.Mesh, direction) ?? default;
            for (int line = cells.FirstLine; line < cells.EndLine; line++)
            {
                for (int sample = cells.FirstSample; sample < cells.EndSample; sample++)
                {
                    int turned = part.Mesh.IsClosed ? (sample + part.Mesh.Samples) % part.Mesh.Samples : sample;
                    if (part.Has(line, turned))
                    {
                        CellCorners corners = part.Corners(line, turned);
                        Try(direction, corners.NorthWest, corners.SouthWest, corners.SouthEast, ref nearest, ref radius);
                        Try(direction, corners.NorthWest, corners.SouthEast, corners.NorthEast, ref nearest, ref radius);
                    }
                }
            }
        }

        if (nearest > WellInside)
        {
            return radius;
        }

        SeamPatch seams = seamsOf();
        for (int block = 0; block < seams.Blocks.Count; block++)
        {
            if (Vector3D.Dot(seams.Blocks[block].Box.Up, direction) >= seams.Blocks[block].Box.CapRadius.Cosine)
            {
                int first = block * SeamPatch.BlockFacets;
                for (int facet = first; facet < first + seams.FacetsOf(block); facet++)
                {
                    (Vector3D a, Vector3D b, Vector3D c) = seams.CornersOf(facet);
                    Try(direction, a, b, c, ref nearest, ref radius);
                }
            }
        }

        return nearest < -WellInside && !parts[0].Mesh.IsClosed ? null
            : double.IsFinite(radius) ? radius
            : throw new InvalidOperationException($"No facet in direction {direction}.");
    }

    /// <summary>Throws an exception for a position that is not above the surface.</summary>
    /// <param name="terrain">The model, or several.</param>
    /// <param name="positionBodyFixed">m, body-fixed.</param>
    /// <exception cref="BadInputException">The position is not above the surface.</exception>
    public static void RequireAbove(ITerrain terrain, Vector3D positionBodyFixed)
    {
        double distance = positionBodyFixed.Length;
        double surface = distance > 0.0 ? RadiusBelow(terrain, positionBodyFixed) : double.PositiveInfinity;
        if (!(distance > surface + Tolerances.VertexLattice))
        {
            throw new BadInputException(Invariant(
                $"The camera is inside the Moon: {distance:R} m from its centre, "
                    + $"where the surface of {terrain.ProductId} is at {surface:R} m. Move it up."));
        }
    }

    /// <summary>
    /// The cell of a direction and its neighbours: straight edges bulge beyond their parallel, so the facet can belong to one of them. Null
    /// outside a map.
    /// </summary>
    private static CellRange? CellsAround(FacetMesh mesh, Vector3D direction)
    {
        if (!mesh.IsClosed)
        {
            CellRange all = mesh.Cells;
            return mesh.PlaceOf(direction) is (double atLine, double atSample)
                ? new CellRange(
                    Math.Max((int)atLine - 1, all.FirstLine),
                    Math.Min((int)atLine + 2, all.EndLine),
                    Math.Max((int)atSample - 1, all.FirstSample),
                    Math.Min((int)atSample + 2, all.EndSample))
                : null;
        }

        SelenographicPoint point = SelenographicPoint.Below(direction);
        int line = (int)Math.Floor(((0.5 - (point.Latitude / Math.PI)) * mesh.Lines) - 0.5);
        int sample = (int)Math.Floor((point.Longitude / (2.0 * Math.PI) * mesh.Samples) - 0.5);
        return new CellRange(
            Math.Clamp(line - 1, -1, mesh.Lines - 1), Math.Clamp(line + 2, 0, mesh.Lines), sample - 1, sample + 2);
    }

    /// <summary>
    /// Intersects the line from the centre with one facet. If several facets are met, the one with the largest minimum barycentric
    /// coordinate of the intersection counts.
    /// </summary>
    /// <remarks>
    /// T. Moeller, B. Trumbore, J. Graphics Tools 2 (1997) 21, with edges as differences of neighbours, so that facets a fraction
    /// of a millimetre wide keep their digits.
    /// </remarks>
    private static void Try(Vector3D direction, Vector3D a, Vector3D b, Vector3D c, ref double nearest, ref double radius)
    {
        Vector3D ab = b - a;
        Vector3D ac = c - a;
        if (ab.Length < ShortestEdge || ac.Length < ShortestEdge || (c - b).Length < ShortestEdge)
        {
            return;
        }

        Vector3D across = Vector3D.Cross(direction, ac);
        double area = Vector3D.Dot(ab, across);
        if (area == 0.0)
        {
            return; // seen edge on
        }

        double v = -Vector3D.Dot(a, across) / area;
        double w = Vector3D.Dot(direction, Vector3D.Cross(ab, a)) / area;
        double inside = Math.Min(1.0 - v - w, Math.Min(v, w));
        if (inside > nearest)
        {
            Vector3D normal = Vector3D.Cross(ab, ac);
            nearest = inside;
            radius = Vector3D.Dot(a, normal) / Vector3D.Dot(direction, normal);
        }
    }
}
