using Msisf.Core.Mesh;
using Msisf.Core.Mesh.Bounds;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Blocks in groups of 4 x 4, these again, up to groups of some tens of degrees, so that a search visits few of the millions of blocks
/// of a fine model. A group's bounds are the model's until all its blocks have been read.
/// </summary>
internal sealed class BlockTree
{
    private const int Fan = 4;

    /// <summary>Blocks of a group of the lowest level.</summary>
    public const int GroupBlocks = Fan * Fan;

    /// <summary>Degrees: a cap about a larger group might pass a hemisphere.</summary>
    private const int LargestGroup = 45;

    private readonly SurfaceModel _surface;
    private readonly BlockLevel[] _levels;
    private readonly BlockBounds _model;
    private readonly double _sagitta;

    public BlockTree(SurfaceModel surface)
    {
        (double min, double max) = surface.Grid.RadiusLimits;
        _surface = surface;
        _model = new BlockBounds(
            MathF.BitDecrement((float)min), MathF.BitIncrement((float)max), float.PositiveInfinity);
        _sagitta = MeshBounds.SagittaFactor(surface.Grid.PixelsPerDegree);
        List<BlockLevel> levels = [];
        for (int edge = 1; edge <= Fan || edge * CellBlock.Size <= LargestGroup * surface.Grid.PixelsPerDegree; edge *= Fan)
        {
            levels.Add(new BlockLevel(surface.Mesh, edge));
        }

        _levels = [.. levels];
    }

    /// <summary>Finds the groups of 4 x 4 blocks that may cast a shadow on a receiver.</summary>
    /// <param name="bounds">Tells whether.</param>
    /// <param name="groups">Gets row and column of each group.</param>
    public void FindGroups(CasterBounds bounds, List<CellBlock> groups)
    {
        int top = _levels.Length - 1;
        for (int row = 0; row < _levels[top].Rows; row++)
        {
            for (int column = 0; column < _levels[top].Columns; column++)
            {
                Descend(top, row, column, bounds, groups);
            }
        }
    }

    /// <summary>Finds the blocks of a group that may cast a shadow on a receiver; reads those that were not read yet.</summary>
    /// <param name="group">From <see cref="FindGroups"/>.</param>
    /// <param name="bounds">Tells whether.</param>
    /// <param name="blocks">Has room for <see cref="GroupBlocks"/>.</param>
    /// <returns>How many.</returns>
    public int FindBlocks(CellBlock group, CasterBounds bounds, Span<CellBlock> blocks)
    {
        BlockLevel level = _levels[0];
        BlockBounds union = new(float.PositiveInfinity, float.NegativeInfinity, 0.0F);
        int count = 0;
        for (int row = group.Row * Fan; row < Math.Min((group.Row + 1) * Fan, level.Rows); row++)
        {
            for (int column = group.Column * Fan; column < Math.Min((group.Column + 1) * Fan, level.Columns); column++)
            {
                CellBlock block = new(row, column);
                BlockBounds found = _surface.Bounds.Of(block);
                union = BlockBounds.Union(union, found);
                if (MayCast(level.CapOf(row, column), found, bounds))
                {
                    blocks[count++] = block;
                }
            }
        }

        _levels[1].Note(group.Row, group.Column, union);
        return count;
    }

    private void Descend(int level, int row, int column, CasterBounds bounds, List<CellBlock> groups)
    {
        if (!MayCast(_levels[level].CapOf(row, column), BoundsOf(level, row, column), bounds))
        {
            return;
        }

        if (level == 1)
        {
            groups.Add(new CellBlock(row, column));
            return;
        }

        BlockLevel children = _levels[level - 1];
        for (int r = row * Fan; r < Math.Min((row + 1) * Fan, children.Rows); r++)
        {
            for (int c = column * Fan; c < Math.Min((column + 1) * Fan, children.Columns); c++)
            {
                Descend(level - 1, r, c, bounds, groups);
            }
        }
    }

    private BlockBounds BoundsOf(int level, int row, int column)
    {
        if (_levels[level].TryGetBounds(row, column, out BlockBounds bounds))
        {
            return bounds;
        }

        return level > 1 && TryUnite(level, row, column, out bounds) ? bounds : _model;
    }

    private bool TryUnite(int level, int row, int column, out BlockBounds union)
    {
        union = new BlockBounds(float.PositiveInfinity, float.NegativeInfinity, 0.0F);
        BlockLevel children = _levels[level - 1];
        for (int r = row * Fan; r < Math.Min((row + 1) * Fan, children.Rows); r++)
        {
            for (int c = column * Fan; c < Math.Min((column + 1) * Fan, children.Columns); c++)
            {
                if (!children.TryGetBounds(r, c, out BlockBounds child))
                {
                    return false;
                }

                union = BlockBounds.Union(union, child);
            }
        }

        _levels[level].Note(row, column, union);
        return true;
    }

    private bool MayCast(SphericalCap cap, BlockBounds found, CasterBounds bounds) => bounds.MayCast(
        cap, (found.Min * _sagitta) - Tolerances.VertexLattice, found.Max + Tolerances.VertexLattice, found.MaxSlope);
}
