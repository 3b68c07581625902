using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Render.Shadows;

/// <summary>Finds the blocks of a model that may throw a shadow on receivers, and shares them among threads.</summary>
internal sealed class CasterSearch
{
    private readonly BlockTree _tree;
    private readonly double _greatestRadius;
    private readonly List<CellBlock> _groups = [];

    /// <summary>Takes the model.</summary>
    /// <param name="surface">The model.</param>
    public CasterSearch(SurfaceModel surface)
    {
        _tree = new BlockTree(surface);
        (double least, double greatest) = surface.Grid.RadiusLimits;
        _greatestRadius = greatest + Tolerances.VertexLattice;
        SolidRadius = (least * MeshBounds.SagittaFactor(surface.Grid.PixelsPerDegree)) - Tolerances.VertexLattice;
    }

    /// <summary>m: no facet is lower.</summary>
    public double SolidRadius { get; }

    /// <summary>Groups of blocks that bounds could not rule out in the last search.</summary>
    public int Groups => _groups.Count;

    /// <summary>Refuses a Sun for which light space has no meaning.</summary>
    /// <exception cref="BadInputException">The Sun is not outside the terrain.</exception>
    public void Check(Vector3D sunMoonMe)
    {
        if (!(sunMoonMe.Length > _greatestRadius))
        {
            throw new BadInputException($"The Sun is at {sunMoonMe} m, inside the Moon; give a position outside it.");
        }
    }

    /// <summary>Goes through the blocks.</summary>
    /// <param name="receivers">The receivers; not empty.</param>
    /// <param name="slope">Of the Sun's disc.</param>
    /// <param name="cast">Gets the worker and a block, one block at a time.</param>
    /// <param name="threads">At most.</param>
    /// <param name="cancellation">Ends the work.</param>
    /// <returns>How many blocks.</returns>
    public int Run(ReceiverSort receivers, double slope, Action<int, CellBlock> cast, int threads, CancellationToken cancellation)
    {
        CasterBounds bounds = new(receivers, slope, _greatestRadius);
        _groups.Clear();
        _tree.FindGroups(bounds, _groups);
        int blocks = 0;
        WorkerTeam.Run(threads, _groups.Count, (worker, group) =>
        {
            Span<CellBlock> found = stackalloc CellBlock[BlockTree.GroupBlocks];
            int count = _tree.FindBlocks(_groups[group], bounds, found);
            Interlocked.Add(ref blocks, count);
            foreach (CellBlock block in found[..count])
            {
                cast(worker, block);
            }
        }, cancellation);
        return blocks;
    }
}
