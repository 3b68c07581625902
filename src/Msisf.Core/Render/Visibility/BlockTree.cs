using Msisf.Core.Camera;
using Msisf.Core.Mesh;

namespace Msisf.Core.Render.Visibility;

/// <summary>The blocks of a model in squares of 2 x 2, 4 x 4, ...: the coarsest ones are some ten to the Moon's girth. Immutable.</summary>
internal sealed class BlockTree
{
    private const int MinColumns = 8;

    private readonly BlockLevel[] _levels;

    public BlockTree(FacetMesh mesh)
    {
        int columns = CellBlock.ColumnsOf(mesh);
        int levels = 1;
        while (columns >> levels >= MinColumns)
        {
            levels++;
        }

        _levels = new BlockLevel[levels];
        for (int level = 0; level < levels; level++)
        {
            _levels[level] = new BlockLevel(mesh, level);
        }
    }

    /// <summary>The blocks themselves.</summary>
    public BlockLevel Blocks => _levels[0];

    /// <summary>
    /// Appends the blocks that may be in the image if all that is known of the surface is how far it may reach; always in the same order.
    /// </summary>
    /// <param name="frustum">The image.</param>
    /// <param name="horizon">What is hidden from the camera.</param>
    /// <param name="limits">m: the model's radii.</param>
    /// <param name="blocks">Filled.</param>
    public void Collect(ViewFrustum frustum, MoonHorizon horizon, (double Min, double Max) limits, List<CellBlock> blocks)
    {
        BlockLevel top = _levels[^1];
        for (int row = 0; row < top.Rows; row++)
        {
            for (int column = 0; column < top.Columns; column++)
            {
                Descend(_levels.Length - 1, row, column, frustum, horizon, limits, blocks);
            }
        }
    }

    private void Descend(
        int level, int row, int column, ViewFrustum frustum, MoonHorizon horizon, (double Min, double Max) limits, List<CellBlock> blocks)
    {
        BlockLevel squares = _levels[level];
        if (row >= squares.Rows || column >= squares.Columns)
        {
            return;
        }

        BlockBox box = squares.Box(row, column, limits.Min, limits.Max);
        if (horizon.Hides(box, limits.Max) || !frustum.TryFindRows(box.Box, out _))
        {
            return;
        }

        if (level == 0)
        {
            blocks.Add(new CellBlock(row, column));
            return;
        }

        for (int child = 0; child < 4; child++)
        {
            Descend(level - 1, (2 * row) + (child >> 1), (2 * column) + (child & 1), frustum, horizon, limits, blocks);
        }
    }
}
