using Msisf.Core.Errors;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Core.Mesh.Bounds;

/// <summary>
/// Bounds of a model's facets in tiles, blocks of a quarter of a tile's edge and, for fine models, of a twentieth. Made by one pass over
/// the model; immutable, safe for several threads.
/// </summary>
public sealed class ElevationSummary
{
    /// <summary>Below this many cells to a block, reading the cells is as quick as one more level.</summary>
    private const int MinCellsOfFineBlock = 4;

    /// <summary>Takes the bounds of the finest blocks and makes the coarser ones.</summary>
    /// <param name="pixelsPerDegree">Samples a degree.</param>
    /// <param name="finest">Row by row, for <see cref="FinestSubdivisions"/>.</param>
    internal ElevationSummary(int pixelsPerDegree, BlockBounds[] finest)
    {
        PixelsPerDegree = pixelsPerDegree;
        List<SummaryLevel> levels = [new SummaryLevel(pixelsPerDegree, FinestSubdivisions(pixelsPerDegree), finest)];
        foreach (int subdivisions in new[] { 4, 1 })
        {
            if (subdivisions < levels[0].Subdivisions)
            {
                levels.Insert(0, Coarsened(levels[0], subdivisions));
            }
        }

        Levels = levels;
        BlockBounds all = levels[0].Bounds.Aggregate(BlockBounds.Union);
        MinRadius = all.Min;
        MaxRadius = all.Max;
    }

    /// <summary>Samples a degree of the model.</summary>
    public int PixelsPerDegree { get; }

    /// <summary>m: no vertex is lower.</summary>
    public double MinRadius { get; }

    /// <summary>m: no vertex is higher.</summary>
    public double MaxRadius { get; }

    /// <summary>Coarsest (tiles) first.</summary>
    public IReadOnlyList<SummaryLevel> Levels { get; }

    /// <summary>Reads the whole model once, line by line.</summary>
    public static ElevationSummary Build(IElevationGrid grid) =>
        new(grid.PixelsPerDegree, new SummaryScan(grid, FinestSubdivisions(grid.PixelsPerDegree)).Run());

    /// <summary>Makes a summary again from what <see cref="ToValues"/> gave.</summary>
    /// <param name="pixelsPerDegree">Samples a degree of the model.</param>
    /// <param name="values">Three a block: minimum and maximum radius (m), tangent of the steepest slope.</param>
    /// <exception cref="BadInputException">The count is not that of a model of this resolution, or a value can't be.</exception>
    public static ElevationSummary FromValues(int pixelsPerDegree, ReadOnlySpan<float> values)
    {
        int subdivisions = FinestSubdivisions(pixelsPerDegree);
        BlockBounds[] blocks = new BlockBounds[TileId.Count * subdivisions * subdivisions];
        if (values.Length != 3 * blocks.Length)
        {
            throw new BadInputException($"The elevation summary has {values.Length} numbers, {3 * blocks.Length} expected; make it again.");
        }

        for (int block = 0; block < blocks.Length; block++)
        {
            BlockBounds bounds = new(values[3 * block], values[(3 * block) + 1], values[(3 * block) + 2]);
            if (!(bounds.Min > 0.0F && bounds.Max >= bounds.Min && bounds.MaxSlope >= 0.0F && float.IsFinite(bounds.Max + bounds.MaxSlope)))
            {
                throw new BadInputException($"Block {block} of the elevation summary can't be: {bounds}; make it again.");
            }

            blocks[block] = bounds;
        }

        return new ElevationSummary(pixelsPerDegree, blocks);
    }

    /// <summary>The bounds of the finest blocks, row by row, three numbers a block; all else follows from them.</summary>
    public float[] ToValues()
    {
        BlockBounds[] blocks = Levels[^1].Bounds;
        float[] values = new float[3 * blocks.Length];
        for (int block = 0; block < blocks.Length; block++)
        {
            (values[3 * block], values[(3 * block) + 1], values[(3 * block) + 2]) = blocks[block];
        }

        return values;
    }

    /// <summary>Blocks to a tile's edge at the finest level.</summary>
    internal static int FinestSubdivisions(int pixelsPerDegree)
    {
        int tileCells = TileId.SizeDegrees * pixelsPerDegree;
        return tileCells >= 20 * MinCellsOfFineBlock ? 20 : 4;
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

    private static SummaryLevel Coarsened(SummaryLevel fine, int subdivisions)
    {
        int factor = fine.Subdivisions / subdivisions;
        int columns = fine.Columns / factor;
        BlockBounds[] coarse = new BlockBounds[fine.Bounds.Length / factor / factor];
        Array.Fill(coarse, new BlockBounds(float.PositiveInfinity, float.NegativeInfinity, 0.0F));
        for (int index = 0; index < fine.Bounds.Length; index++)
        {
            int target = (index / fine.Columns / factor * columns) + (index % fine.Columns / factor);
            coarse[target] = BlockBounds.Union(coarse[target], fine.Bounds[index]);
        }

        return new SummaryLevel(fine.TileCells / TileId.SizeDegrees, subdivisions, coarse);
    }
}
