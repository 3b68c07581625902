using Msisf.Core.Numerics;
using Msisf.Core.Parallel;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>Finds the <see cref="DarkZones"/> of the receivers of a frame. One object serves many frames and keeps its memory.</summary>
internal sealed class DarkZoneSearch
{
    /// <summary>Number of blocks that may cast a shadow above which zones save time, if receivers are crowded too.</summary>
    private const int ManyBlocks = 128;

    /// <summary>
    /// Number of receivers, in a square as wide as the disc at the greatest distance of a shadow, above which zones save time: under a
    /// polar Sun there are thousands, in a view from afar hundreds.
    /// </summary>
    private const double ManyReceivers = 1200.0;

    /// <summary>
    /// Maximum number of blocks whose facets are read for the zones, as a multiple of the blocks that may cast a shadow: with more, the
    /// search could cost more than it saves.
    /// </summary>
    private const int BlocksPerCaster = 2;

    /// <summary>Distance between planes, in cells: with one cell, reading the terrain takes longer by as much as the tests save.</summary>
    private const double CellsPerPlane = 2.0;

    private readonly SurfaceModel _surface;
    private readonly GridPatch? _model;
    private readonly NodeBounds _modelBounds;
    private readonly double _maxRadius;
    private readonly double _solidRadius;
    private readonly DarkZones _zones = new();
    private readonly List<TerrainSections> _sections = [];
    private readonly List<CellBlock> _blocks = [];
    private readonly List<LightBounds> _unknown = [];

    /// <summary>Makes a search for a model.</summary>
    /// <param name="surface">The model.</param>
    public DarkZoneSearch(SurfaceModel surface)
    {
        _surface = surface;
        _model = surface.Parts.Count == 1 ? surface.Parts[0] : null;
        (double min, double max) = surface.RadiusLimits;
        _modelBounds = new NodeBounds(MathF.BitDecrement((float)min), MathF.BitIncrement((float)max), float.PositiveInfinity);
        _maxRadius = max + Tolerances.VertexLattice;
        _solidRadius = surface.SolidRadius(min);
    }

    /// <summary>Whether the zones save more time than they take.</summary>
    /// <param name="receivers">The receivers.</param>
    /// <param name="slope">Radius of the Sun's disc over its distance.</param>
    /// <param name="casters">Number of blocks that may cast a shadow.</param>
    public bool Pays(ReceiverSort receivers, double slope, int casters)
    {
        LightBox box = receivers.Box;
        double reach = slope * (receivers.Grid.MaxDepth() - MinDepth(box));
        return _model is not null && casters > ManyBlocks
            && receivers.Grid.Length * 4.0 * reach * reach > ManyReceivers * (box.MaxU - box.MinU) * (box.MaxV - box.MinV);
    }

    /// <summary>Finds the zones.</summary>
    /// <param name="receivers">The receivers; not empty.</param>
    /// <param name="slope">Radius of the Sun's disc over its distance.</param>
    /// <param name="casters">Number of blocks that may cast a shadow.</param>
    /// <param name="threads">Maximum number of threads.</param>
    /// <param name="cancellation">Cancels the work.</param>
    /// <returns>
    /// The zones, valid until the next search; null if they would cost too much, or the surface is not one model of the whole Moon.
    /// </returns>
    public DarkZones? Find(ReceiverSort receivers, double slope, int casters, int threads, CancellationToken cancellation)
    {
        LightBox box = receivers.Box;
        double deepest = receivers.Grid.MaxDepth();
        double minDepth = MinDepth(box);
        if (_model is null || !(_solidRadius > 0.0 && deepest > minDepth && box.MaxV > box.MinV && box.MinU < _maxRadius))
        {
            return null;
        }

        // A line of a model of latitude and longitude is as far from the next one everywhere.
        double cell = 2.0 * Math.PI * _maxRadius / _model.Mesh.Samples;
        SectionGrid grid = new(box, minDepth, deepest, CellsPerPlane * cell, slope);
        _blocks.Clear();
        _unknown.Clear();
        BoundsLayout layout = _model.Bounds.Layout;
        int top = layout.Levels - 1;
        NodeRange all = new(0, layout.Rows(top), 0, layout.Columns(top));
        if (!TryCollect(_model.Bounds, top, all, receivers.Frame, grid, BlocksPerCaster * casters))
        {
            return null;
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

    /// <summary>Collects all terrain that the planes may cut; false if it is too much.</summary>
    private bool TryCollect(BoundsTree tree, int level, NodeRange nodes, LightFrame frame, SectionGrid grid, int max)
    {
        for (int row = nodes.FirstRow; row < nodes.EndRow; row++)
        {
            for (int column = nodes.FirstColumn; column < nodes.EndColumn; column++)
            {
                bool isKnown = tree.TryGetKnown(level, row, column, out NodeBounds known);
                LightBounds bounds = LightBounds.Of(
                    frame, tree.NodeOf(tree.CapOf(level, row, column), isKnown ? known : _modelBounds));
                if (!(bounds.Box.MaxU >= 0.0 && bounds.Box.MaxV >= grid.MinV && bounds.Box.MinV <= grid.MaxV
                    && bounds.MaxDepth >= grid.MinDepth && bounds.MinDepth <= grid.DepthOf(grid.Planes)))
                {
                    continue;
                }

                if (level > SquareLayout.CellBlockLevel)
                {
                    if (!TryCollect(tree, level - 1, tree.Layout.ChildrenOf(level, row, column), frame, grid, max))
                    {
                        return false;
                    }
                }
                else if (isKnown)
                {
                    _blocks.Add(new CellBlock(row, column));
                }
                else
                {
                    _unknown.Add(bounds);
                }

                if (_blocks.Count + _unknown.Count > max)
                {
                    return false;
                }
            }
        }

        return true;
    }
}
