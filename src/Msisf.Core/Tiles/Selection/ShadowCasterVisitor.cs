using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>
/// Keeps the tiles that can cast a shadow on the visible part of a tile: a tile is kept if a ray from there to the Sun can meet one of
/// its facets that are turned away from the Sun. The search does not stop at a kept ridge above the ray, because the ray may enter the
/// ground before the ridge, through a tile that is left out.
/// </summary>
internal sealed class ShadowCasterVisitor : ISightVisitor
{
    /// <summary>
    /// Maximum number of visible facets that are tested one by one; after that all tiles that may cast a shadow on a block are kept.
    /// </summary>
    private const int MaxFacets = 3_000;

    private readonly SunView _sun;
    private readonly BackFaces _facets;
    private readonly bool[] _kept;
    private readonly List<TileId> _newlyKept;
    private readonly List<TileId>[] _candidates;
    private readonly AzimuthIndex<TileId> _tiles = new(72);
    private int _facetBudget = MaxFacets;

    /// <param name="sun">The Moon from the Sun.</param>
    /// <param name="summary">Bounds of the terrain.</param>
    /// <param name="patch">Buffer for reading terrain; not the one that the walk uses.</param>
    /// <param name="kept">Whether each tile is kept; tiles that cast shadows are added.</param>
    /// <param name="newlyKept">Receives the tiles that are added.</param>
    public ShadowCasterVisitor(SunView sun, ElevationSummary summary, TerrainPatch patch, bool[] kept, List<TileId> newlyKept)
    {
        (_sun, _kept, _newlyKept) = (sun, kept, newlyKept);
        _facets = new BackFaces(sun.Table, summary, sun.Position, patch);
        foreach (TileId tile in TileId.FromNorth)
        {
            _tiles.Add(tile, sun.Table.Possible(tile));
        }

        _candidates = [.. summary.Levels.Select(_ => new List<TileId>())];
    }

    public Visit Node(in SeenNode seen)
    {
        TerrainNode node = seen.Node;
        PolarBounds fromSun = _sun.View.Bounds(node);
        if (_facets.AreAllOf(node, fromSun))
        {
            return Visit.Skip; // black without any shadow
        }

        // Of a node's candidates those of the nodes in it are chosen.
        List<TileId> found = _candidates[seen.Place.Level];
        found.Clear();
        IEnumerable<TileId> asked = seen.Place.Level + 1 == _candidates.Length ? TilesAround(fromSun) : _candidates[seen.Place.Level + 1];
        foreach (TileId tile in asked)
        {
            // For a target that is not read, nothing of the tile is read either.
            if (MayCast(tile, fromSun) && (node.IsUnread || AnyFacetCasts(tile, fromSun)))
            {
                found.Add(tile);
            }
        }

        if (found.Count > 0 && seen.Place.Level == 0 && _facetBudget <= 0)
        {
            KeepCasters(fromSun);
            return Visit.Skip;
        }

        return found.Count == 0 ? Visit.Skip : Visit.Descend;
    }

    public Visit Facet(ReadOnlySpan<Vector3D> part, in PolarBounds bounds, in Facet facet)
    {
        _facetBudget--;
        if (!facet.TurnsAwayFrom(_sun.Position))
        {
            KeepCasters(_sun.View.Bounds(part));
        }

        return Visit.Descend;
    }

    private static bool IsBefore(in PolarBounds caster, in PolarBounds target) =>
        caster.Near < target.Far && caster.CanShareRayWith(target);

    private void KeepCasters(in PolarBounds target)
    {
        foreach (TileId tile in _candidates[0])
        {
            if (MayCast(tile, target) && AnyFacetCasts(tile, target))
            {
                _kept[tile.Number] = true;
                _newlyKept.Add(tile);
            }
        }
    }

    private IEnumerable<TileId> TilesAround(in PolarBounds target)
    {
        List<TileId> tiles = [];
        foreach (int bin in _tiles.Bins(target))
        {
            tiles.AddRange(_tiles[bin]);
        }

        return tiles.Distinct();
    }

    private bool MayCast(TileId tile, in PolarBounds target) =>
        !_kept[tile.Number] && IsBefore(_sun.Table.Possible(tile), target);

    /// <summary>
    /// A ray to the Sun enters the ground first through a facet that is turned away from the Sun: only the tile of this facet is needed.
    /// </summary>
    private bool AnyFacetCasts(TileId tile, in PolarBounds target)
    {
        for (int block = 0; block < _sun.Table.BlocksPerTile; block++)
        {
            if (!IsBefore(_sun.Table.Possible(tile, block), target) || !IsBefore(_sun.Table.Exact(tile, block), target))
            {
                continue;
            }

            foreach (ref readonly PolarBounds facet in _facets.Of(tile, block))
            {
                if (IsBefore(facet, target))
                {
                    return true;
                }
            }
        }

        return false;
    }
}
