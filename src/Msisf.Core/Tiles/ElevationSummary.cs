using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tiles;

/// <summary>
/// Bounds of a model's facets in all tiles and parts of tiles (<see cref="TileLayout"/>), known from the beginning or read when they are
/// requested. Safe for several threads.
/// </summary>
public sealed class ElevationSummary
{
    private readonly BoundsTree _tree;
    private readonly TileLayout _layout;
    private readonly IGlobalGrid? _grid;

    private ElevationSummary(BoundsTree tree, TileLayout layout, NodeBounds limits, IGlobalGrid? grid = null)
    {
        _grid = grid;
        _tree = tree;
        _layout = layout;
        Levels = [.. Enumerable.Range(0, layout.Levels).Reverse().Select(level => new SummaryLevel(tree, layout, level, limits))];
        MinRadius = limits.Min;
        MaxRadius = limits.Max;
    }

    /// <summary>Samples a degree of the model.</summary>
    public int PixelsPerDegree => _layout.PixelsPerDegree;

    /// <summary>Minimum radius of a vertex, m; of a summary on demand, the limit that the model gives.</summary>
    public double MinRadius { get; }

    /// <summary>Maximum radius of a vertex, m; of a summary on demand, the limit that the model gives.</summary>
    public double MaxRadius { get; }

    /// <summary>Number of samples that were read on demand.</summary>
    public long SamplesRead => _tree.SamplesRead;

    /// <summary>Whether parts are read when they are requested.</summary>
    internal bool IsOnDemand => _grid is not null;

    /// <summary>Levels of the summary, coarsest (tiles) first.</summary>
    public IReadOnlyList<SummaryLevel> Levels { get; }

    /// <summary>The levels as a tree, of which level 0 is the finest.</summary>
    internal BoundsLayout Layout => _layout;

    /// <summary>The level of a node of the tree.</summary>
    internal SummaryLevel LevelOf(NodePlace node) => Levels[^(node.Level + 1)];

    /// <summary>A tile as a node of the tree.</summary>
    internal NodePlace PlaceOf(TileId tile) => new(Levels.Count - 1, tile.RowFromNorth, tile.Column);

    /// <summary>Reads the whole model once, line by line.</summary>
    public static ElevationSummary Build(IGlobalGrid grid)
    {
        TileLayout layout = new(grid.PixelsPerDegree);
        BoundsTree tree = new(layout, new FacetMesh(grid));
        tree.ReadAll();
        NodeBounds all = NodeBounds.Empty;
        for (int tile = 0; tile < TileId.Count; tile++)
        {
            all = NodeBounds.Union(all, tree.Of(layout.Levels - 1, tile / TileId.Columns, tile % TileId.Columns));
        }

        return new ElevationSummary(tree, layout, all with { MaxSlope = float.PositiveInfinity });
    }

    /// <summary>Makes a summary that reads the parts of the model that are requested, each once.</summary>
    /// <param name="known">What is known of it: <see cref="ToValues"/> of an earlier summary, or nothing.</param>
    /// <exception cref="BadInputException">The count is not that of a model of this resolution, or a value is impossible.</exception>
    public static ElevationSummary OnDemand(IGlobalGrid grid, ReadOnlySpan<float> known = default)
    {
        TileLayout layout = new(grid.PixelsPerDegree);
        BoundsTree tree = new(layout, new FacetMesh(grid));
        int columns = layout.Columns(0);
        int blocks = layout.Rows(0) * columns;
        if (known.Length != 3 * blocks && !known.IsEmpty)
        {
            throw new BadInputException($"The elevation summary has {known.Length} numbers, {3 * blocks} expected; make it again.");
        }

        for (int block = 0; block < known.Length / 3; block++)
        {
            NodeBounds bounds = new(known[3 * block], known[(3 * block) + 1], known[(3 * block) + 2]);
            if (bounds == default)
            {
                continue;
            }

            if (!(bounds.Min > 0.0F && bounds.Max >= bounds.Min && bounds.MaxSlope >= 0.0F && float.IsFinite(bounds.Max + bounds.MaxSlope)))
            {
                throw new BadInputException($"Block {block} of the elevation summary can't be: {bounds}; make it again.");
            }

            tree.Set(0, block / columns, block % columns, bounds);
        }

        (double min, double max) = grid.RadiusLimits;
        return new ElevationSummary(
            tree, layout, new NodeBounds(MathF.BitDecrement((float)min), MathF.BitIncrement((float)max), float.PositiveInfinity), grid);
    }

    /// <summary>
    /// The bounds of the finest blocks that are known, row by row, three numbers a block: minimum and maximum radius (m), tangent of the
    /// steepest slope. Those of the others are 0.
    /// </summary>
    public float[] ToValues()
    {
        int columns = _layout.Columns(0);
        float[] values = new float[3 * _layout.Rows(0) * columns];
        for (int block = 0; block < values.Length / 3; block++)
        {
            if (_tree.TryGetKnown(0, block / columns, block % columns, out NodeBounds bounds))
            {
                (values[3 * block], values[(3 * block) + 1], values[(3 * block) + 2]) = bounds;
            }
        }

        return values;
    }

    /// <summary>Reads what is not known of some tiles, on all cores.</summary>
    internal void Read(IEnumerable<TileId> tiles)
    {
        if (_grid is null)
        {
            return;
        }

        int side = _layout.Subdivisions(0);
        TileId[] unread = [.. tiles.Where(tile => Levels[0].NodeUnread(tile).IsUnread)];
        System.Threading.Tasks.Parallel.For(0, unread.Length * side, job =>
        {
            (int index, int row) = int.DivRem(job, side);
            _tree.ReadRow((unread[index].RowFromNorth * side) + row, unread[index].Column * side, side);
        });
        if (unread.Length > 0)
        {
            _grid.ReleasePages(); // what is drawn of it is read once more
        }
    }

    /// <summary>Refuses a summary of another model.</summary>
    /// <exception cref="BadInputException">The resolutions differ.</exception>
    internal void CheckFits(IGlobalGrid grid)
    {
        if (grid.PixelsPerDegree != PixelsPerDegree)
        {
            throw new BadInputException(
                $"The elevation summary is of a model with {PixelsPerDegree} px/deg, but {grid.ProductId} has {grid.PixelsPerDegree}; "
                    + $"make it again.");
        }
    }
}
