using Msisf.Core.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>
/// Keeps the tiles that can cast a shadow on the visible part of a tile: a tile is kept if a ray from there to the Sun can meet one of
/// its facets that are turned away from the Sun. The search does not stop at a kept ridge above the ray, because the ray may enter the
/// ground before the ridge, through a tile that is left out.
/// </summary>
internal sealed class ShadowCasterVisitor : ISurfaceVisitor
{
    /// <summary>
    /// Maximum number of visible facets that are tested one by one; after that all tiles that may cast a shadow on a block are kept.
    /// </summary>
    private const int MaxFacets = 3_000;

    private readonly SunView _sun;
    private readonly ElevationSummary _summary;
    private readonly BackFaces _facets;
    private readonly bool[] _kept;
    private readonly List<TileId> _newlyKept;
    private readonly List<TileId>[] _candidates;
    private readonly AzimuthIndex<TileId> _tiles = new(72);
    private readonly int[] _asked = new int[TileId.Count];
    private int _question;
    private int _facetBudget = MaxFacets;

    /// <param name="sun">The Moon from the Sun.</param>
    /// <param name="summary">Bounds of the terrain.</param>
    /// <param name="patch">Buffer for reading terrain; not the one that the walk uses.</param>
    /// <param name="kept">Whether each tile is kept; tiles that cast shadows are added.</param>
    /// <param name="newlyKept">Receives the tiles that are added.</param>
    public ShadowCasterVisitor(SunView sun, ElevationSummary summary, TerrainPatch patch, bool[] kept, List<TileId> newlyKept)
    {
        _sun = sun;
        _summary = summary;
        _facets = new BackFaces(sun.Table, summary, sun.Position, patch);
        _kept = kept;
        _newlyKept = newlyKept;
        foreach (TileId tile in TileId.FromNorth)
        {
            _tiles.Add(tile, sun.Table.Possible(tile));
        }

        _candidates = [.. summary.Levels.Select(_ => new List<TileId>())];
    }

    public Visit Node(in TerrainNode node, in PolarBounds bounds, bool certain, NodePlace place)
    {
        PolarBounds fromSun = _sun.View.Bounds(node);
        if (_facets.AreAllOf(node, fromSun))
        {
            return Visit.Skip; // black without any shadow
        }

        List<TileId> found = _candidates[place.Depth];
        found.Clear();
        if (place.Depth == 0)
        {
            AddAllCasting(found, fromSun, node.IsUnread);
        }
        else
        {
            foreach (TileId tile in _candidates[place.Depth - 1])
            {
                AddIfCasting(found, tile, fromSun, node.IsUnread);
            }
        }

        if (found.Count == 0)
        {
            return Visit.Skip;
        }

        if (place.Depth + 1 == _summary.Levels.Count && _facetBudget <= 0)
        {
            KeepCasters(fromSun);
            return Visit.Skip;
        }

        return Visit.Descend;
    }

    public Visit Facet(ReadOnlySpan<Vector3D> part, in PolarBounds bounds, in Facet facet)
    {
        _facetBudget--;
        if (facet.TurnsAwayFrom(_sun.Position))
        {
            return Visit.Descend;
        }

        KeepCasters(SurfaceWalk.BoundsOf(_sun.View, part));
        return Visit.Descend;
    }

    private void KeepCasters(in PolarBounds target)
    {
        foreach (TileId tile in _candidates[^1])
        {
            if (!_kept[tile.Number] && IsBefore(_sun.Table.Possible(tile), target) && AnyFacetCasts(tile, target))
            {
                _kept[tile.Number] = true;
                _newlyKept.Add(tile);
            }
        }
    }

    private static bool IsBefore(in PolarBounds caster, in PolarBounds target) =>
        caster.Near < target.Far && caster.CanShareRayWith(target);

    private void AddAllCasting(List<TileId> found, in PolarBounds target, bool isUnread)
    {
        _question++;
        foreach (int bin in _tiles.Bins(target))
        {
            foreach (TileId tile in _tiles[bin])
            {
                if (_asked[tile.Number] != _question)
                {
                    _asked[tile.Number] = _question;
                    AddIfCasting(found, tile, target, isUnread);
                }
            }
        }
    }

    /// <summary>Adds a tile if it may cast a shadow; for a target that is not read, nothing of the tile is read either.</summary>
    private void AddIfCasting(List<TileId> found, TileId tile, in PolarBounds target, bool isUnread)
    {
        if (!_kept[tile.Number] && IsBefore(_sun.Table.Possible(tile), target) && (isUnread || AnyFacetCasts(tile, target)))
        {
            found.Add(tile);
        }
    }

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
