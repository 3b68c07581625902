using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>Finds the blocks of a surface that may cast a shadow on receivers.</summary>
internal sealed class CasterSearch
{
    private readonly BlockSearch<CellBlock> _search;
    private readonly NodeBounds _limits;
    private readonly double _maxRadius;

    /// <summary>Makes a search on a surface.</summary>
    public CasterSearch(SurfaceModel surface)
    {
        _search = new BlockSearch<CellBlock>(surface);
        _limits = NodeBounds.Within(surface.RadiusLimits);
        _maxRadius = surface.RadiusLimits.Max + Tolerances.VertexLattice;
        SolidRadius = surface.SolidRadius(surface.RadiusLimits.Min);
    }

    /// <summary>Lower bound of the distance of all facets from the Moon's centre, m; 0 if the surface is not closed.</summary>
    public double SolidRadius { get; }

    /// <summary>Number of groups of blocks that bounds could not rule out in the last search.</summary>
    public int Groups => _search.Groups;

    /// <summary>Throws if the Sun is not outside the terrain, where light space is undefined.</summary>
    /// <exception cref="BadInputException">The Sun is not outside the terrain.</exception>
    public void Check(Vector3D sunBodyFixed)
    {
        if (!(sunBodyFixed.Length > _maxRadius))
        {
            throw new BadInputException($"The Sun is at {sunBodyFixed} m, inside the Moon; give a position outside it.");
        }
    }

    /// <summary>Finds the blocks that may cast a shadow on a receiver; reads blocks that were not read yet.</summary>
    /// <param name="receivers">The receivers; not empty.</param>
    /// <param name="slope">Radius of the Sun's disc over its distance; 0 for a point.</param>
    /// <returns>The blocks; the list is valid until the next search.</returns>
    public IReadOnlyList<CellBlock> Find(IReceiverBounds receivers, double slope, int threads, CancellationToken cancellation) =>
        _search.Find(new Casters(BoundsOf(receivers, slope), _limits), threads, cancellation);

    /// <summary>Tells of single nodes whether they may cast a shadow on a receiver.</summary>
    /// <param name="receivers">The receivers; not empty.</param>
    /// <param name="slope">Radius of the Sun's disc over its distance; 0 for a point.</param>
    public CasterBounds BoundsOf(IReceiverBounds receivers, double slope) => new(receivers, slope, _maxRadius);

    private readonly struct Casters(CasterBounds bounds, NodeBounds limits) : IBlockTester<CellBlock>
    {
        /// <remarks>A node has the bounds of the model until all its blocks have been read. A single block is read at once.</remarks>
        public bool MayHold(Patch patch, NodePlace node) => node.Level == SquareLayout.CellBlockLevel
            || bounds.MayCast(patch.NodeOf(node, patch.TryGetKnown(node, out NodeBounds known) ? known : limits));

        public bool TryFind(Patch patch, CellBlock block, out CellBlock found)
        {
            found = block;
            return bounds.MayCast(patch.NodeOf(block.Node, patch.BoundsOf(block.Node)));
        }

        public CellBlock BlockOf(CellBlock found) => found;

        public CellBlock WithBlock(CellBlock found, CellBlock piece) => piece;
    }
}
