using Msisf.Core.Parallel;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>Finds the <see cref="DarkZones"/> of the receivers of a frame. One object serves many frames and keeps its memory.</summary>
internal sealed class DarkZoneSearch
{
    /// <summary>Number of blocks that may cast a shadow above which zones save time, if receivers are crowded too.</summary>
    private const int ManyBlocks = 128;

    /// <summary>
    /// Number of receivers, in a square as wide as the disc at the greatest distance of a shadow, above which zones save time: with 45 they
    /// take as much as they save, with 180 they save a fifth of an image's time; under a polar Sun there are thousands.
    /// </summary>
    private const double ManyReceivers = 150.0;

    /// <summary>
    /// Maximum number of blocks whose facets are read for the zones, as a multiple of the blocks that may cast a shadow: with more, the
    /// search could cost more than it saves.
    /// </summary>
    private const int BlocksPerCaster = 2;

    /// <summary>Distance between planes, in cells: with one cell, reading the terrain takes longer by as much as the tests save.</summary>
    private const double CellsPerPlane = 2.0;

    private readonly SurfaceModel _surface;
    private readonly NodeBounds _limits;
    private readonly double _cell;
    private readonly double _maxRadius;
    private readonly double _solidRadius;
    private readonly DarkZones _zones = new();
    private readonly List<TerrainSections> _sections = [];
    private readonly List<CellBlock> _blocks = [];
    private readonly List<LightBounds> _unknown = [];

    /// <summary>Makes a search on a surface.</summary>
    public DarkZoneSearch(SurfaceModel surface)
    {
        _surface = surface;
        _limits = NodeBounds.Within(surface.RadiusLimits);
        _maxRadius = surface.RadiusLimits.Max + Tolerances.VertexLattice;
        _solidRadius = surface.SolidRadius(surface.RadiusLimits.Min);
        _cell = _maxRadius * surface.Parts.Where(part => !part.IsLeftOut).Min(part => part.CellAngle);
    }

    /// <summary>Whether the zones save more time than they take.</summary>
    /// <param name="slope">Radius of the Sun's disc over its distance.</param>
    /// <param name="casters">Number of blocks that may cast a shadow.</param>
    public bool Pays(PlacedReceivers receivers, double slope, int casters)
    {
        LightBox box = receivers.Box;
        double reach = slope * (receivers.MaxDepth - MinDepth(box));
        return _solidRadius > 0.0 && casters > ManyBlocks
            && receivers.Length * 4.0 * reach * reach > ManyReceivers * (box.MaxU - box.MinU) * (box.MaxV - box.MinV);
    }

    /// <summary>Finds the zones.</summary>
    /// <param name="receivers">The receivers; not empty.</param>
    /// <param name="slope">Radius of the Sun's disc over its distance.</param>
    /// <param name="casters">Number of blocks that may cast a shadow.</param>
    /// <returns>
    /// The zones, valid until the next search; null if they would cost too much, or the surface is not closed.
    /// </returns>
    public DarkZones? Find(PlacedReceivers receivers, double slope, int casters, int threads, CancellationToken cancellation)
    {
        LightBox box = receivers.Box;
        double deepest = receivers.MaxDepth;
        double minDepth = MinDepth(box);
        if (!(_solidRadius > 0.0 && deepest > minDepth && box.MaxV > box.MinV && box.MinU < _maxRadius))
        {
            return null;
        }

        SectionGrid grid = new(box, minDepth, deepest, CellsPerPlane * _cell, slope);
        _blocks.Clear();
        _unknown.Clear();
        for (int part = 0; part < _surface.Patches.Length; part++)
        {
            Collector collector = new(this, part, receivers.Frame, grid, BlocksPerCaster * casters);
            if (!_surface.Patches[part].IsLeftOut && !NodeWalk.All(_surface.Patches[part].Layout, ref collector))
            {
                return null;
            }
        }

        while (_sections.Count < threads)
        {
            _sections.Add(new TerrainSections());
        }

        WorkerTeam.Run(threads, threads, (_, part) =>
        {
            TerrainSections sections = _sections[part];
            sections.Start(grid);
            for (int i = part; i < _blocks.Count; i += threads)
            {
                cancellation.ThrowIfCancellationRequested();
                sections.Add(_surface, _blocks[i], receivers.Frame);
            }
        }, cancellation);
        TerrainSections whole = _sections[0];
        for (int part = 1; part < threads; part++)
        {
            whole.Add(_sections[part]);
        }

        foreach (LightBounds bounds in _unknown)
        {
            whole.AddUnknown(in bounds);
        }

        _zones.Compute(grid, whole.Lowest.AsMemory(0, grid.Planes * grid.Columns), _solidRadius, slope, threads, cancellation);
        return _zones;
    }

    /// <summary>Depth, m, before which no terrain is as high as the lowest receiver.</summary>
    private double MinDepth(in LightBox receivers)
    {
        double low = Math.Max(receivers.MinU, 0.0);
        return -Math.Sqrt((_maxRadius - low) * (_maxRadius + low));
    }

    /// <summary>Collects all terrain that the planes may cut, and stops if it is too much.</summary>
    private readonly struct Collector(DarkZoneSearch search, int part, LightFrame frame, SectionGrid grid, int max) : INodeTester
    {
        public Visit Test(NodePlace node)
        {
            Patch patch = search._surface.Patches[part];
            bool isKnown = patch.TryGetKnown(node, out NodeBounds known);
            LightBounds bounds = LightBounds.Of(frame, patch.NodeOf(node, isKnown ? known : search._limits));
            if (!(bounds.Box.MaxU >= 0.0 && bounds.Box.MaxV >= grid.MinV && bounds.Box.MinV <= grid.MaxV
                && bounds.MaxDepth >= grid.MinDepth && bounds.MinDepth <= grid.DepthOf(grid.Planes)))
            {
                return Visit.Skip;
            }

            if (node.Level > SquareLayout.CellBlockLevel)
            {
                return Visit.Descend;
            }

            CellBlock block = new(node.Row, node.Column) { Part = part };
            (int first, int count) = patch.PiecesOf(block);
            for (int piece = first; piece < first + count && isKnown; piece++)
            {
                search._blocks.Add(block with { Piece = piece });
            }

            if (!isKnown && count > 0)
            {
                search._unknown.Add(bounds);
            }

            return search._blocks.Count + search._unknown.Count > max ? Visit.Stop : Visit.Skip;
        }
    }
}
