using Msisf.Core.Errors;
using Msisf.Core.Mesh;
using Msisf.Core.Mesh.Bounds;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shadows;

/// <summary>Finds the blocks of a model that may throw a shadow on receivers.</summary>
internal sealed class CasterSearch
{
    private readonly BlockTree _tree;
    private readonly double _maxRadius;
    private readonly List<CellBlock> _groups = [];
    private readonly List<CellBlock> _blocks = [];
    private CellBlock[] _found = [];
    private int[] _counts = [];

    /// <summary>Takes the model.</summary>
    /// <param name="surface">The model.</param>
    public CasterSearch(SurfaceModel surface)
    {
        _tree = new BlockTree(surface);
        (double min, double max) = surface.Grid.RadiusLimits;
        _maxRadius = max + Tolerances.VertexLattice;
        SolidRadius = (min * MeshBounds.SagittaFactor(surface.Grid.PixelsPerDegree)) - Tolerances.VertexLattice;
    }

    /// <summary>m: no facet is lower.</summary>
    public double SolidRadius { get; }

    /// <summary>Groups of blocks that bounds could not rule out in the last search.</summary>
    public int Groups => _groups.Count;

    /// <summary>Refuses a Sun for which light space has no meaning.</summary>
    /// <exception cref="BadInputException">The Sun is not outside the terrain.</exception>
    public void Check(Vector3D sunMoonMe)
    {
        if (!(sunMoonMe.Length > _maxRadius))
        {
            throw new BadInputException($"The Sun is at {sunMoonMe} m, inside the Moon; give a position outside it.");
        }
    }

    /// <summary>Finds the blocks; reads those that were not read yet.</summary>
    /// <param name="receivers">The receivers; not empty.</param>
    /// <param name="slope">Of the Sun's disc.</param>
    /// <param name="threads">At most.</param>
    /// <param name="cancellation">Ends the work.</param>
    /// <returns>The blocks, until the next search.</returns>
    public IReadOnlyList<CellBlock> Find(ReceiverSort receivers, double slope, int threads, CancellationToken cancellation)
    {
        CasterBounds bounds = new(receivers, slope, _maxRadius);
        _groups.Clear();
        _tree.FindGroups(bounds, _groups);
        if (_counts.Length < _groups.Count)
        {
            _counts = new int[2 * _groups.Count];
            _found = new CellBlock[2 * _groups.Count * BlockTree.GroupBlocks];
        }

        WorkerTeam.Run(
            threads,
            _groups.Count,
            (_, group) => _counts[group] = _tree.FindBlocks(_groups[group], bounds, BlocksOf(group)),
            cancellation);
        _blocks.Clear();
        for (int group = 0; group < _groups.Count; group++)
        {
            _blocks.AddRange(BlocksOf(group)[.._counts[group]]);
        }

        return _blocks;
    }

    private Span<CellBlock> BlocksOf(int group) => _found.AsSpan(group * BlockTree.GroupBlocks, BlockTree.GroupBlocks);
}
