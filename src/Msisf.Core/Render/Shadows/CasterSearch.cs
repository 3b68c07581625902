using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Parallel;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>Finds the blocks of a model that may cast a shadow on receivers.</summary>
internal sealed class CasterSearch
{
    private readonly SurfaceModel _surface;
    private readonly NodeBounds _modelBounds;
    private readonly double _maxRadius;
    private readonly List<CellBlock> _groups = [];
    private readonly List<CellBlock> _blocks = [];
    private CellBlock[] _found = [];
    private int[] _counts = [];

    /// <summary>Makes a search for a model.</summary>
    /// <param name="surface">The model.</param>
    public CasterSearch(SurfaceModel surface)
    {
        _surface = surface;
        (double min, double max) = surface.RadiusLimits;
        _modelBounds = new NodeBounds(MathF.BitDecrement((float)min), MathF.BitIncrement((float)max), float.PositiveInfinity);
        _maxRadius = max + Tolerances.VertexLattice;
        SolidRadius = surface.SolidRadius(min);
    }

    /// <summary>Lower bound of the distance of all facets from the Moon's centre, m; 0 if the surface is not closed.</summary>
    public double SolidRadius { get; }

    /// <summary>Number of groups of blocks that bounds could not rule out in the last search.</summary>
    public int Groups => _groups.Count;

    /// <summary>Throws if the Sun is not outside the terrain, where light space is undefined.</summary>
    /// <exception cref="BadInputException">The Sun is not outside the terrain.</exception>
    public void Check(Vector3D sunMoonMe)
    {
        if (!(sunMoonMe.Length > _maxRadius))
        {
            throw new BadInputException($"The Sun is at {sunMoonMe} m, inside the Moon; give a position outside it.");
        }
    }

    /// <summary>Finds the blocks that may cast a shadow on a receiver; reads blocks that were not read yet.</summary>
    /// <param name="receivers">The receivers; not empty.</param>
    /// <param name="slope">Radius of the Sun's disc over its distance; 0 for a point.</param>
    /// <param name="threads">Maximum number of threads.</param>
    /// <param name="cancellation">Cancels the work.</param>
    /// <returns>The blocks; the list is valid until the next search.</returns>
    public IReadOnlyList<CellBlock> Find(IReceiverBounds receivers, double slope, int threads, CancellationToken cancellation)
    {
        CasterBounds bounds = new(receivers, slope, _maxRadius);
        _groups.Clear();
        for (int part = 0; part < _surface.Parts.Count; part++)
        {
            if (_surface.Parts[part].IsLeftOut)
            {
                continue;
            }

            BoundsLayout layout = _surface.Parts[part].Bounds.Layout;
            int top = layout.Levels - 1;
            FindGroups(part, top, new NodeRange(0, layout.Rows(top), 0, layout.Columns(top)), bounds);
        }

        if (_counts.Length < _groups.Count)
        {
            _counts = new int[2 * _groups.Count];
            _found = new CellBlock[2 * _groups.Count * SquareLayout.GroupBlocks];
        }

        WorkerTeam.Run(
            threads,
            _groups.Count,
            (_, group) => _counts[group] = FindBlocks(_groups[group], bounds, BlocksOf(group)),
            cancellation);
        _blocks.Clear();
        for (int group = 0; group < _groups.Count; group++)
        {
            foreach (CellBlock block in BlocksOf(group)[.._counts[group]])
            {
                Add(block);
            }
        }

        AddSeams(bounds);
        return _blocks;
    }

    /// <summary>Adds a block, or the pieces of it that finer models have left.</summary>
    private void Add(CellBlock block)
    {
        if (_surface.Parts[block.Part].Kept is not { } kept || kept.StateOf(block.Row, block.Column) == CellMask.BlockState.Whole)
        {
            _blocks.Add(block);
            return;
        }

        (int first, int count) = kept.PiecesOf(block.Row, block.Column);
        for (int piece = first; piece < first + count; piece++)
        {
            _blocks.Add(block with { Piece = piece + 1 });
        }
    }

    private void AddSeams(CasterBounds bounds)
    {
        for (int number = 0; number < _surface.Seams.Blocks.Count; number++)
        {
            if (bounds.MayCast(_surface.Seams.Blocks[number].Node))
            {
                _blocks.Add(new CellBlock(0, number) { Part = _surface.Parts.Count });
            }
        }
    }

    /// <summary>
    /// Finds the groups that may cast a shadow on a receiver. A node has the bounds of the model until all its blocks have been read.
    /// </summary>
    private void FindGroups(int part, int level, NodeRange nodes, CasterBounds bounds)
    {
        BoundsTree tree = _surface.Parts[part].Bounds;
        for (int row = nodes.FirstRow; row < nodes.EndRow; row++)
        {
            for (int column = nodes.FirstColumn; column < nodes.EndColumn; column++)
            {
                if (!MayCast(
                    tree, level, row, column, tree.TryGetKnown(level, row, column, out NodeBounds known) ? known : _modelBounds, bounds))
                {
                    continue;
                }

                if (level == SquareLayout.GroupLevel)
                {
                    _groups.Add(new CellBlock(row, column) { Part = part });
                }
                else
                {
                    FindGroups(part, level - 1, tree.Layout.ChildrenOf(level, row, column), bounds);
                }
            }
        }
    }

    /// <summary>Finds the blocks of a group of blocks that may cast a shadow on a receiver; reads blocks that were not read yet.</summary>
    private int FindBlocks(CellBlock group, CasterBounds bounds, Span<CellBlock> blocks)
    {
        GridPatch part = _surface.Parts[group.Part];
        BoundsTree tree = part.Bounds;
        NodeRange children = tree.Layout.ChildrenOf(SquareLayout.GroupLevel, group.Row, group.Column);
        int count = 0;
        for (int row = children.FirstRow; row < children.EndRow; row++)
        {
            for (int column = children.FirstColumn; column < children.EndColumn; column++)
            {
                if (part.Kept?.StateOf(row, column) != CellMask.BlockState.Empty
                    && MayCast(
                        tree, SquareLayout.CellBlockLevel, row, column, tree.Of(SquareLayout.CellBlockLevel, row, column), bounds))
                {
                    blocks[count++] = new CellBlock(row, column) { Part = group.Part };
                }
            }
        }

        return count;
    }

    private static bool MayCast(BoundsTree tree, int level, int row, int column, NodeBounds found, CasterBounds bounds) =>
        bounds.MayCast(tree.NodeOf(tree.CapOf(level, row, column), found));

    private Span<CellBlock> BlocksOf(int group) => _found.AsSpan(group * SquareLayout.GroupBlocks, SquareLayout.GroupBlocks);
}
