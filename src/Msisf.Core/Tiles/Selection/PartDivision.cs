using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>
/// Divides the tiles of one selection into parts, leaves out those that the image does not need, and gives each a level of detail.
/// </summary>
/// <param name="run">The selection of tiles, done.</param>
/// <param name="rule">Gives the level that is allowed at a place.</param>
/// <param name="summary">Bounds of the terrain.</param>
/// <param name="subdivisionsAt">Number of parts along a tile's edge at a level.</param>
/// <param name="deviationOf">How far a part's surface lies from the model's, m.</param>
internal sealed class PartDivision(
    DspsaRun run,
    DetailRule rule,
    PixelFootprint footprint,
    ElevationSummary summary,
    Func<int, int> subdivisionsAt,
    Func<SurfacePart, double> deviationOf)
{
    private readonly SummaryLevel _tiles = summary.Levels[0];
    private readonly SummaryLevel _finest = summary.Levels[^1];
    private readonly VisibleBlockVisitor _seen = new(summary, run.View, run.Sun);
    private readonly ShadowDemand? _shadows = run.Sun is null ? null : new(run.Sun, summary, run.Patch, rule, footprint);
    private readonly List<SurfacePart> _parts = [];
    private readonly (double WidestCell, double MaxDeviation)?[] _demands =
        new (double, double)?[summary.Levels[^1].Subdivisions * summary.Levels[^1].Subdivisions];

    /// <summary>The parts, in order.</summary>
    public IReadOnlyList<SurfacePart> Divide(TileSelection selection)
    {
        TileId[] kept = [.. selection.Kept.Select(choice => choice.Tile)];
        // what only throws shadows is asked part by part
        TileId[] divided = [.. kept.Where(tile => !run.IsSeen(tile) || subdivisionsAt(LevelOf(tile)) > 1)];
        foreach (TileId tile in divided.Where(run.IsSeen))
        {
            run.Walk(tile, _seen);
        }

        AddTargets(kept.Except(divided), divided);
        KeepDarkBlocks(kept);
        _parts.AddRange(kept.Except(divided).Select(tile => SurfacePart.Whole(tile, LevelOf(tile))));
        foreach (TileId tile in divided)
        {
            FillDemands(tile);
            Divide(SurfacePart.Whole(tile));
        }

        _parts.Sort();
        return _parts;
    }

    /// <summary>The coarsest level allowed for the visible ground of a tile.</summary>
    private int LevelOf(TileId tile) => LevelOf(tile, _tiles.NodeUnread(tile).Cap, subdivisions: 1);

    /// <summary>
    /// The coarsest level allowed for the visible ground of a tile within a cap, whose heights are bounded by those of the tile; or a
    /// coarser one that needs smaller parts too. The tile is read only if the limits of the model leave that open.
    /// </summary>
    /// <param name="cap">The place.</param>
    /// <param name="subdivisions">Number of parts along the tile's edge beyond which the level does not matter.</param>
    private int LevelOf(TileId tile, SphericalCap cap, int subdivisions)
    {
        TerrainNode unread = _tiles.NodeUnread(tile) with { Cap = cap };
        if (unread.IsUnread)
        {
            (double min, double max) = footprint.LimitsOfMinWidth(
                unread.Ball(), unread.MinRadius * cap.Centre, unread.MaxRadius * cap.Centre);
            int coarsest = rule.LevelOfPixel(max);
            if (coarsest == rule.LevelOfPixel(min) || subdivisionsAt(coarsest) > subdivisions)
            {
                return coarsest;
            }
        }

        return rule.LevelOfPixel(footprint.MinWidth((_tiles.NodeOf(tile) with { Cap = cap }).Ball()));
    }

    /// <summary>
    /// Notes ground that is seen and may be lit. Ground that is certainly dark is left out, because a missing shadow does not change it.
    /// </summary>
    private void AddTargets(IEnumerable<TileId> whole, IEnumerable<TileId> divided)
    {
        if (_shadows is null)
        {
            return;
        }

        foreach (TileId tile in whole)
        {
            _shadows.AddTarget(_tiles.NodeOf(tile));
        }

        foreach (TileId tile in divided)
        {
            bool[] seen = _seen.Of(tile);
            for (int block = 0; block < seen.Length; block++)
            {
                if (seen[block])
                {
                    _shadows.AddTarget(_finest.NodeOf(tile, block));
                }
            }
        }
    }

    /// <summary>
    /// A dark block is as black as the sky: it is needed only if ground behind it would show without it, or if its shadow falls on kept
    /// ground. A dark block that is kept is seen, so the ground that keeps it dark is needed too.
    /// </summary>
    private void KeepDarkBlocks(IEnumerable<TileId> kept)
    {
        if (_seen.Dark.Count == 0)
        {
            return;
        }

        OccluderVisitor cover = run.CoverOf([.. _seen.Dark.Select(dark => dark.Tile).Distinct()]);
        cover.LookFor(kept);
        List<VisibleBlockVisitor.DarkBlock> open = [.. _seen.Dark];
        Keep(open, dark => cover.MayCover(dark.Bounds));
        while (Keep(open, dark => _shadows!.Of(_finest.NodeOf(dark.Tile, dark.Block)) is not null))
        {
            // Dark blocks that were kept may need further ground to stay dark.
        }
    }

    private bool Keep(List<VisibleBlockVisitor.DarkBlock> open, Predicate<VisibleBlockVisitor.DarkBlock> isNeeded)
    {
        List<VisibleBlockVisitor.DarkBlock> needed = open.FindAll(isNeeded);
        foreach (VisibleBlockVisitor.DarkBlock dark in needed)
        {
            _seen.Of(dark.Tile)[dark.Block] = true;
            _shadows!.AddTarget(_finest.NodeOf(dark.Tile, dark.Block));
        }

        open.RemoveAll(dark => _seen.Of(dark.Tile)[dark.Block]);
        return needed.Count > 0;
    }

    /// <summary>The cap that holds a part.</summary>
    private SphericalCap CapOf(SurfacePart part)
    {
        int cells = _tiles.TileCells / part.Subdivisions;
        int line = part.Tile.FirstLine(summary.PixelsPerDegree) + (part.Row * cells);
        int sample = part.Tile.FirstSample(summary.PixelsPerDegree) + (part.Column * cells);
        CellRange range = new(line == 0 ? -1 : line, line + cells, sample, sample + cells);
        return MeshBounds.CapOf(range, _tiles.Lines, 2 * _tiles.Lines);
    }

    private void FillDemands(TileId tile)
    {
        bool[] seen = _seen.Of(tile);
        for (int block = 0; block < _demands.Length; block++)
        {
            _demands[block] = seen[block] ? null : DemandOn(tile, block);
        }
    }

    /// <summary>What shadows demand of a block; it is read only if its shadow may fall on a target with some height of the model.</summary>
    private (double WidestCell, double MaxDeviation)? DemandOn(TileId tile, int block)
    {
        (int row, int column) = _finest.PlaceOf(tile, block);
        TerrainNode unread = _finest.NodeUnread(row, column);
        return _shadows is null || (unread.IsUnread && _shadows.Of(unread) is null) ? null : _shadows.Of(_finest.Node(row, column));
    }

    private void Divide(SurfacePart square)
    {
        (bool isSeen, double widestCell, double deviation) = DemandOn(square);
        if (!isSeen && widestCell == double.PositiveInfinity)
        {
            return;
        }

        int level = isSeen
            ? LevelOf(square.Tile, CapOf(square), square.Subdivisions)
            : CasterLevel(square, widestCell, deviation);
        if (subdivisionsAt(level) <= square.Subdivisions)
        {
            _parts.Add(square with { Level = LevelWithWholeCells(level, square.Subdivisions) });
            return;
        }

        foreach (SurfacePart quarter in square.Quarters())
        {
            Divide(quarter);
        }
    }

    /// <summary>
    /// Whether any block that the square touches is seen, and the smallest cell width and height error (m) that shadows allow these
    /// blocks.
    /// </summary>
    private (bool IsSeen, double WidestCell, double MaxDeviation) DemandOn(SurfacePart square)
    {
        bool[] seen = _seen.Of(square.Tile);
        int side = _finest.Subdivisions;
        int parts = square.Subdivisions;
        bool isSeen = false;
        double widestCell = double.PositiveInfinity;
        double deviation = double.PositiveInfinity;
        for (int row = square.Row * side / parts; row * parts < (square.Row + 1) * side; row++)
        {
            for (int column = square.Column * side / parts; column * parts < (square.Column + 1) * side; column++)
            {
                isSeen |= seen[(row * side) + column];
                if (_demands[(row * side) + column] is (double, double) demand)
                {
                    widestCell = Math.Min(widestCell, demand.WidestCell);
                    deviation = Math.Min(deviation, demand.MaxDeviation);
                }
            }
        }

        return (isSeen, widestCell, deviation);
    }

    /// <summary>
    /// The coarsest level that keeps the edges of shadows; where that level has parts smaller than the square, its quarters are tested
    /// one by one.
    /// </summary>
    private int CasterLevel(SurfacePart square, double widestCell, double deviation)
    {
        int level = rule.LevelOfCell(widestCell);
        while (level > 0 && subdivisionsAt(level) <= square.Subdivisions
            && deviationOf(square with { Level = LevelWithWholeCells(level, square.Subdivisions) }) > deviation)
        {
            level--;
        }

        return level;
    }

    private int LevelWithWholeCells(int level, int subdivisions)
    {
        while (TileId.SizeDegrees * (summary.PixelsPerDegree >> level) % subdivisions != 0)
        {
            level--;
        }

        return level;
    }
}
