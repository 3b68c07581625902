using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>
/// Finds where facets lie that may be turned away from a viewpoint. Only through such a facet can a ray to the viewpoint enter the
/// ground, and a ray from the viewpoint leave the ground. A block's facets are read when they are first needed.
/// </summary>
/// <param name="summary">Bounds of the terrain.</param>
/// <param name="viewpoint">m, body-fixed.</param>
/// <param name="patch">Buffer for reading terrain; not the one that a walk uses.</param>
internal sealed class BackFaces(BoundsTable table, ElevationSummary summary, Vector3D viewpoint, TerrainPatch patch)
{
    /// <summary>
    /// Maximum number of cells of a block that is read; for larger blocks the bounds of the block are used in place of its facets.
    /// </summary>
    private const int MaxCellsRead = 64;

    /// <summary>
    /// Maximum number of blocks that are read, some 10 microseconds each; for the others the bounds of the block are used.
    /// </summary>
    private const int MaxBlocksRead = 100;

    private readonly PolarBounds[]?[] _facets = new PolarBounds[TileId.Count * table.BlocksPerTile][];
    private int _blocksToRead = MaxBlocksRead;

    /// <summary>Bounds of the facets of a tile's block that may be turned away.</summary>
    public ReadOnlySpan<PolarBounds> Of(TileId tile, int block) =>
        _facets[(tile.Number * table.BlocksPerTile) + block] ??= Find(tile, block, table.Exact(tile, block));

    /// <summary>Whether the viewpoint's elevation over a node's ground may be lower than the slope of its steepest facet.</summary>
    public bool MayBeIn(in TerrainNode node, in PolarBounds bounds)
    {
        SineCosine farthest = AngleOf(bounds.Far);
        double distance = table.View.Distance;
        return !((distance * farthest.Cosine) - node.MaxRadius > node.MaxSlope * distance * farthest.Sine);
    }

    /// <summary>Whether the viewpoint is so far below a node's horizon that all its facets are certainly turned away.</summary>
    public bool AreAllOf(in TerrainNode node, in PolarBounds bounds) =>
        GroundFacing.IsTurnedAway(AngleOf(bounds.Near), table.View.Distance, node.MinRadius, node.MaxSlope);

    /// <summary>The angle whose half has a sine.</summary>
    private static SineCosine AngleOf(double halfSine)
    {
        double cosine = 1.0 - (2.0 * halfSine * halfSine);
        return new SineCosine(Math.Sqrt(Math.Max(0.0, (1.0 - cosine) * (1.0 + cosine))), cosine);
    }

    private PolarBounds[] Find(TileId tile, int block, in PolarBounds bounds)
    {
        SummaryLevel level = summary.Levels[1];
        (int row, int column) = level.PlaceOf(tile, block);
        if (!MayBeIn(level.Node(row, column), bounds))
        {
            return [];
        }

        CellRange cells = level.Cells(row, column);
        if (cells.Lines * cells.Samples > MaxCellsRead || _blocksToRead-- <= 0)
        {
            return [bounds];
        }

        List<PolarBounds> found = [];
        patch.Load(cells);
        for (int line = 0; line + 1 < patch.Lines; line++)
        {
            for (int sample = 0; sample + 1 < patch.Samples; sample++)
            {
                (Facet southWest, Facet northEast) = Facet.OfCell(patch, line, sample);
                AddIfTurned(southWest);
                AddIfTurned(northEast);
            }
        }

        return [.. found];

        void AddIfTurned(in Facet facet)
        {
            if (!facet.FacesCertainly(viewpoint))
            {
                found.Add(table.View.Bounds([facet.A, facet.B, facet.C]));
            }
        }
    }
}

/// <summary>A triangle of the mesh, counter-clockwise from outside; corners in m, body-fixed.</summary>
internal readonly record struct Facet(Vector3D A, Vector3D B, Vector3D C)
{
    /// <summary>The two facets of a cell of a patch.</summary>
    public static (Facet SouthWest, Facet NorthEast) OfCell(TerrainPatch patch, int line, int sample)
    {
        (Vector3D northWest, Vector3D southEast) = (patch[line, sample], patch[line + 1, sample + 1]);
        return (new Facet(northWest, patch[line + 1, sample], southEast), new Facet(northWest, southEast, patch[line, sample + 1]));
    }

    /// <summary>Whether a point (m, MOON_ME) is certainly behind the facet's plane, wherever rounding puts the vertices.</summary>
    public bool TurnsAwayFrom(Vector3D viewpoint) => Side(viewpoint, out double margin) < -margin;

    /// <summary>Whether a point (m, MOON_ME) is certainly before the facet's plane; a facet without area faces all.</summary>
    public bool FacesCertainly(Vector3D viewpoint) => Side(viewpoint, out double margin) > margin || A == B || B == C || C == A;

    private double Side(Vector3D viewpoint, out double margin)
    {
        (Vector3D u, Vector3D v, Vector3D toViewpoint) = (B - A, C - A, viewpoint - A);
        double sides = Math.Sqrt(u.LengthSquared) + Math.Sqrt(v.LengthSquared);
        double reach = Math.Sqrt(toViewpoint.LengthSquared) + Math.Sqrt(u.LengthSquared) + Math.Sqrt(v.LengthSquared);
        margin = 2.0 * Tolerances.VertexLattice * (sides + Tolerances.VertexLattice) * reach;
        return Vector3D.Dot(Vector3D.Cross(u, v), toViewpoint);
    }
}
