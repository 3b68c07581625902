using Msisf.Core.Camera;
using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>
/// Finds out whether a dark tile hides part of the kept tiles from the camera. A ray that enters the ground through the tile leaves it
/// through a facet turned away from the camera; only what lies beyond that facet would show if the tile were left out.
/// </summary>
internal sealed class OccluderVisitor : ISightVisitor
{
    private const int Bins = 360;

    /// <summary>
    /// Maximum number of facets that are tested one by one; after that a block counts as hiding everything behind its bounds.
    /// </summary>
    private const int MaxFacets = 1500;

    private readonly ElevationSummary _summary;
    private readonly BoundsTable _table;
    private readonly BackFaces _facets;
    private readonly double _limb;
    private readonly AzimuthIndex<TileId> _soughtTiles = new(Bins);
    private readonly AzimuthIndex<PolarBounds> _backFaces = new(Bins);
    private int _facetBudget = MaxFacets;

    /// <param name="summary">Bounds of the terrain.</param>
    /// <param name="frame">The image.</param>
    /// <param name="table">Bounds from the camera.</param>
    /// <param name="patch">Buffer for reading terrain; not the one that the walk uses.</param>
    /// <param name="dark">The dark tiles that will be tested.</param>
    public OccluderVisitor(ElevationSummary summary, ViewFrustum frame, BoundsTable table, TerrainPatch patch, IReadOnlyList<TileId> dark)
    {
        (_summary, _table) = (summary, table);
        _facets = new BackFaces(table, summary, frame.CameraBodyFixed, patch);

        // Beyond the limb of a sphere as high as the highest terrain, facets are assumed to be turned away.
        _limb = PolarView.Arc(Math.Min(1.0, summary.MaxRadius / table.View.Distance));
        AzimuthIndex<TileId> asked = new(Bins);
        foreach (TileId tile in dark)
        {
            asked.Add(tile, table.Possible(tile));
        }

        (SummaryLevel tiles, SummaryLevel blocks) = (summary.Levels[0], summary.Levels[1]);
        foreach (TileId tile in TileId.FromNorth)
        {
            if (!summary.IsOnDemand
                ? IsPossible(tiles.NodeOf(tile), table.Possible(tile))
                : IsPossible(tiles.NodeOfLimits(tile.RowFromNorth, tile.Column), table.Possible(tile))
                    && Enumerable.Range(0, table.BlocksPerTile).Any(block =>
                    {
                        (int row, int column) = blocks.PlaceOf(tile, block);
                        return IsPossible(blocks.NodeOfLimits(row, column), table.Possible(tile, block));
                    }))
            {
                NoteBackFaces(tile, asked);
            }
        }

        bool IsPossible(in TerrainNode node, in PolarBounds bounds) => bounds.Near < _limb && SharesRay(asked, bounds)
            && _facets.MayBeIn(node, bounds) && frame.Classify(node.Ball()) != FrustumSide.Outside;
    }

    /// <summary>Whether one of the sought tiles may lie behind the tile that was walked.</summary>
    public bool Covers { get; private set; }

    /// <summary>Prepares for the next tile.</summary>
    public void Reset() => Covers = false;

    /// <summary>Sets the sought tiles.</summary>
    public void LookFor(IEnumerable<TileId> tiles)
    {
        _soughtTiles.Clear();
        foreach (TileId tile in tiles)
        {
            _soughtTiles.Add(tile, _table.Possible(tile));
        }
    }

    public Visit Node(in SeenNode seen)
    {
        if (!MayCover(seen.Bounds))
        {
            return Visit.Skip;
        }

        NodePlace place = seen.Place;
        SummaryLevel level = _summary.LevelOf(place);
        if (level == _summary.Levels[0] || _facetBudget > 0)
        {
            return Visit.Descend;
        }

        // The limits of a node that is not read are too wide for the last word.
        Covers = !seen.Node.IsUnread || MayCover(_table.View.Bounds(level.Node(place.Row, place.Column)));
        return Covers ? Visit.Stop : Visit.Skip;
    }

    public Visit Facet(ReadOnlySpan<Vector3D> part, in PolarBounds bounds, in Facet facet)
    {
        _facetBudget--;
        Covers = MayCover(bounds);
        return Covers ? Visit.Stop : Visit.Descend;
    }

    /// <summary>Whether one of the sought tiles may lie behind a piece of the surface.</summary>
    public bool MayCover(in PolarBounds target)
    {
        double exit = FirstExit(target);
        foreach (int bin in _soughtTiles.Bins(target))
        {
            foreach (TileId tile in _soughtTiles[bin])
            {
                PolarBounds possible = _table.Possible(tile);
                if (possible.Far > exit && possible.CanShareRayWith(target) && AnyBlockBehind(tile, target, exit))
                {
                    return true;
                }
            }
        }

        return false;
    }

    /// <summary>
    /// Whether a ray that enters the Moon through a tile may leave it before the limb: such tiles hide each other in long chains.
    /// </summary>
    public bool MayLeaveBeforeLimb(TileId tile) => FirstExit(_table.Possible(tile)) < _limb && FirstExit(_table.Exact(tile)) < _limb;

    private bool SharesRay(AzimuthIndex<TileId> index, in PolarBounds bounds)
    {
        foreach (int bin in index.Bins(bounds))
        {
            foreach (TileId tile in index[bin])
            {
                if (_table.Possible(tile).CanShareRayWith(bounds))
                {
                    return true;
                }
            }
        }

        return false;
    }

    private void NoteBackFaces(TileId tile, AzimuthIndex<TileId> asked)
    {
        for (int block = 0; block < _table.BlocksPerTile; block++)
        {
            ref readonly PolarBounds possible = ref _table.Possible(tile, block);
            if (possible.Near < _limb && (!_summary.IsOnDemand || SharesRay(asked, possible)))
            {
                foreach (PolarBounds facet in _facets.Of(tile, block))
                {
                    _backFaces.Add(facet, facet);
                }
            }
        }
    }

    private bool AnyBlockBehind(TileId tile, in PolarBounds target, double exit)
    {
        for (int block = 0; block < _table.BlocksPerTile; block++)
        {
            ref readonly PolarBounds possible = ref _table.Possible(tile, block);
            if (possible.Far > exit && possible.CanShareRayWith(target) && _table.Exact(tile, block).CanShareRayWith(target))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>The minimum arc at which a ray that entered through the target can leave the Moon.</summary>
    private double FirstExit(in PolarBounds target)
    {
        double exit = _limb;
        foreach (int bin in _backFaces.Bins(target))
        {
            foreach (PolarBounds facet in _backFaces[bin])
            {
                if (facet.Near < exit && facet.Far > target.Near && facet.CanShareRayWith(target))
                {
                    exit = facet.Near;
                    if (exit <= target.Near)
                    {
                        return target.Near;
                    }
                }
            }
        }

        return Math.Max(exit, target.Near);
    }
}
