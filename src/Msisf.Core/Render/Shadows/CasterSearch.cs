using Msisf.Core.Errors;
using Msisf.Core.Mesh;
using Msisf.Core.Mesh.Bounds;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shadows;

/// <summary>Finds the blocks of a model that may cast a shadow on receivers.</summary>
internal sealed class CasterSearch
{
    private readonly BoundsTree _tree;
    private readonly NodeBounds _modelBounds;
    private readonly double _maxRadius;
    private readonly List<(int Row, int Column)> _groups = [];
    private readonly List<CellBlock> _blocks = [];
    private CellBlock[] _found = [];
    private int[] _counts = [];

    /// <summary>Makes a search for a model.</summary>
    /// <param name="surface">The model.</param>
    public CasterSearch(SurfaceModel surface)
    {
        _tree = surface.Bounds;
        (double min, double max) = surface.Grid.RadiusLimits;
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
    public IReadOnlyList<CellBlock> Find(ReceiverSort receivers, double slope, int threads, CancellationToken cancellation)
    {
        CasterBounds bounds = new(receivers, slope, _maxRadius);
        _groups.Clear();
        int top = _tree.Layout.Levels - 1;
        FindGroups(top, new NodeRange(0, _tree.Layout.Rows(top), 0, _tree.Layout.Columns(top)), bounds);
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
            _blocks.AddRange(BlocksOf(group)[.._counts[group]]);
        }

        return _blocks;
    }

    /// <summary>
    /// Finds the groups that may cast a shadow on a receiver. A node has the bounds of the model until all its blocks have been read.
    /// </summary>
    private void FindGroups(int level, NodeRange nodes, CasterBounds bounds)
    {
        for (int row = nodes.FirstRow; row < nodes.EndRow; row++)
        {
            for (int column = nodes.FirstColumn; column < nodes.EndColumn; column++)
            {
                if (!MayCast(
                    level, row, column, _tree.TryGetKnown(level, row, column, out NodeBounds known) ? known : _modelBounds, bounds))
                {
                    continue;
                }

                if (level == SquareLayout.GroupLevel)
                {
                    _groups.Add((row, column));
                }
                else
                {
                    FindGroups(level - 1, _tree.Layout.ChildrenOf(level, row, column), bounds);
                }
            }
        }
    }

    /// <summary>Finds the blocks of a group that may cast a shadow on a receiver; reads blocks that were not read yet.</summary>
    private int FindBlocks((int Row, int Column) group, CasterBounds bounds, Span<CellBlock> blocks)
    {
        NodeRange children = _tree.Layout.ChildrenOf(SquareLayout.GroupLevel, group.Row, group.Column);
        int count = 0;
        for (int row = children.FirstRow; row < children.EndRow; row++)
        {
            for (int column = children.FirstColumn; column < children.EndColumn; column++)
            {
                if (MayCast(SquareLayout.CellBlockLevel, row, column, _tree.Of(SquareLayout.CellBlockLevel, row, column), bounds))
                {
                    blocks[count++] = new CellBlock(row, column);
                }
            }
        }

        return count;
    }

    private bool MayCast(int level, int row, int column, NodeBounds found, CasterBounds bounds) =>
        bounds.MayCast(_tree.NodeOf(_tree.CapOf(level, row, column), found));

    private Span<CellBlock> BlocksOf(int group) => _found.AsSpan(group * SquareLayout.GroupBlocks, SquareLayout.GroupBlocks);
}
