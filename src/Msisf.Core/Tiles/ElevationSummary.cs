using Msisf.Core.Errors;
using Msisf.Core.Mesh;
using Msisf.Core.Mesh.Bounds;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tiles;

/// <summary>
/// Bounds of a model's facets in all tiles and parts of tiles (<see cref="TileLayout"/>). Immutable, safe for several threads.
/// </summary>
public sealed class ElevationSummary
{
    private readonly BoundsTree _tree;
    private readonly TileLayout _layout;

    private ElevationSummary(BoundsTree tree, TileLayout layout)
    {
        _tree = tree;
        _layout = layout;
        Levels = [.. Enumerable.Range(0, layout.Levels).Reverse().Select(level => new SummaryLevel(tree, layout, level))];
        NodeBounds all = NodeBounds.Empty;
        ForEachNode(layout.Levels - 1, (_, bounds) => all = NodeBounds.Union(all, bounds));
        MinRadius = all.Min;
        MaxRadius = all.Max;
    }

    /// <summary>Samples a degree of the model.</summary>
    public int PixelsPerDegree => _layout.PixelsPerDegree;

    /// <summary>Minimum radius of a vertex, m.</summary>
    public double MinRadius { get; }

    /// <summary>Maximum radius of a vertex, m.</summary>
    public double MaxRadius { get; }

    /// <summary>Levels of the summary, coarsest (tiles) first.</summary>
    public IReadOnlyList<SummaryLevel> Levels { get; }

    /// <summary>Reads the whole model once, line by line.</summary>
    public static ElevationSummary Build(IElevationGrid grid)
    {
        TileLayout layout = new(grid.PixelsPerDegree);
        BoundsTree tree = new(layout, new FacetMesh(grid));
        tree.ReadAll();
        return new ElevationSummary(tree, layout);
    }

    /// <summary>Restores a summary from the numbers of <see cref="ToValues"/>.</summary>
    /// <param name="pixelsPerDegree">Samples a degree of the model.</param>
    /// <param name="values">Three a block: minimum and maximum radius (m), tangent of the steepest slope.</param>
    /// <exception cref="BadInputException">The count is not that of a model of this resolution, or a value is impossible.</exception>
    public static ElevationSummary FromValues(int pixelsPerDegree, ReadOnlySpan<float> values)
    {
        TileLayout layout = new(pixelsPerDegree);
        int columns = layout.Columns(0);
        int blocks = layout.Rows(0) * columns;
        if (values.Length != 3 * blocks)
        {
            throw new BadInputException($"The elevation summary has {values.Length} numbers, {3 * blocks} expected; make it again.");
        }

        BoundsTree tree = new(layout, mesh: null);
        for (int block = 0; block < blocks; block++)
        {
            NodeBounds bounds = new(values[3 * block], values[(3 * block) + 1], values[(3 * block) + 2]);
            if (!(bounds.Min > 0.0F && bounds.Max >= bounds.Min && bounds.MaxSlope >= 0.0F && float.IsFinite(bounds.Max + bounds.MaxSlope)))
            {
                throw new BadInputException($"Block {block} of the elevation summary can't be: {bounds}; make it again.");
            }

            tree.Set(0, block / columns, block % columns, bounds);
        }

        return new ElevationSummary(tree, layout);
    }

    /// <summary>
    /// The bounds of the finest blocks, row by row, three numbers a block; the whole summary can be restored from them.
    /// </summary>
    public float[] ToValues()
    {
        float[] values = new float[3 * _layout.Rows(0) * _layout.Columns(0)];
        ForEachNode(0, (block, bounds) => (values[3 * block], values[(3 * block) + 1], values[(3 * block) + 2]) = bounds);
        return values;
    }

    /// <summary>Refuses a summary of another model.</summary>
    /// <exception cref="BadInputException">The resolutions differ.</exception>
    internal void CheckFits(IElevationGrid grid)
    {
        if (grid.PixelsPerDegree != PixelsPerDegree)
        {
            throw new BadInputException(
                $"The elevation summary is of a model with {PixelsPerDegree} px/deg, but {grid.ProductId} has {grid.PixelsPerDegree}; "
                    + $"make it again.");
        }
    }

    private void ForEachNode(int level, Action<int, NodeBounds> act)
    {
        int columns = _layout.Columns(level);
        for (int block = 0; block < _layout.Rows(level) * columns; block++)
        {
            act(block, _tree.Of(level, block / columns, block % columns));
        }
    }
}
