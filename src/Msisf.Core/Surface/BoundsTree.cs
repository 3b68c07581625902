namespace Msisf.Core.Surface;

/// <summary>
/// Minimum radius, maximum radius and maximum slope of the surface in nodes of several sizes (<see cref="BoundsLayout"/>), with the cap and
/// the box in which each node lies. The bounds of a node are computed at the first request. Safe for several threads: if two compute the
/// same bounds at the same time, they get the same result.
/// </summary>
internal sealed class BoundsTree
{
    /// <summary>Number of samples that are read for bounds before their memory is released: 8 MB of 16-bit samples.</summary>
    private const int SamplesBetweenReleases = 1 << 22;

    /// <summary>
    /// Number of samples of a node that are fetched together, at most, before they are read: most of a line's pages are asked for by one
    /// call, and none leaves memory before it is read.
    /// </summary>
    private const long MaxSamplesFetched = SamplesBetweenReleases;

    /// <summary>
    /// Number of samples of a node for which it pays to ask whether they are in memory: they are read in some 10 microseconds, and asking
    /// takes 1.
    /// </summary>
    private const long MinSamplesFetched = 1 << 12;

    private readonly FacetMesh? _mesh;
    private readonly NodeReader? _reader;
    private readonly NodeStore[] _stores;
    private readonly NodeGeometry?[] _geometries;
    private readonly PlaneNodes? _plane;
    private readonly double _sagitta;
    private long _samplesRead;

    /// <summary>Makes a tree that reads its nodes.</summary>
    /// <param name="layout">How the mesh is divided.</param>
    /// <param name="mesh">
    /// The mesh; nothing of it is read yet. Null if the bounds of all nodes of the finest level are set before any are requested.
    /// </param>
    /// <param name="geometry">Geometry of the mesh; null for one of latitude and longitude.</param>
    public BoundsTree(BoundsLayout layout, FacetMesh? mesh, MeshGeometry? geometry = null)
    {
        Layout = layout;
        _mesh = mesh;
        _plane = (geometry as PlaneGeometry)?.Nodes;
        _reader = mesh is null ? null : new NodeReader(mesh, _plane);
        _stores = new NodeStore[layout.Levels];
        _geometries = new NodeGeometry?[layout.Levels];
        for (int level = 0; level < layout.Levels; level++)
        {
            _stores[level] = new NodeStore(layout.Rows(level), layout.Columns(level));
        }

        _sagitta = geometry?.Sagitta ?? MeshBounds.SagittaFactor(layout.Samples / 360);
    }

    /// <summary>How the mesh is divided.</summary>
    public BoundsLayout Layout { get; }

    /// <summary>The bounds of a node; parts that are not known yet are read.</summary>
    /// <exception cref="BadInputException">
    /// The model cannot be read there, or has a radius outside the range of the Moon's surface.
    /// </exception>
    public NodeBounds Of(int level, int row, int column)
    {
        if (_stores[level].TryGet(row, column, out NodeBounds bounds))
        {
            return bounds;
        }

        if (_reader?.Known(Layout.Cells(level, row, column)) is { } known)
        {
            _stores[level].Set(row, column, known);
            return known;
        }

        if (level > Layout.CoarsestReadLevel)
        {
            TryUnite(level, row, column, reads: true, out bounds);
            return bounds;
        }

        CellRange cells = Layout.Cells(level, row, column);
        Prefetch(cells);
        bounds = _reader!.Read(cells);
        long count = (long)cells.Lines * cells.Samples;
        long read = Interlocked.Add(ref _samplesRead, count);
        if (!_mesh!.IsClosed && read / SamplesBetweenReleases != (read - count) / SamplesBetweenReleases)
        {
            _mesh.Grid.ReleasePages(); // a line of a large map fits between two faults: all of it is mapped for 33 samples
        }

        Set(level, row, column, bounds);
        return bounds;
    }

    /// <summary>Gets the bounds of a node if they follow from known bounds; nothing is read.</summary>
    public bool TryGetKnown(int level, int row, int column, out NodeBounds bounds) =>
        _stores[level].TryGet(row, column, out bounds)
        || (level > Layout.CoarsestReadLevel && TryUnite(level, row, column, reads: false, out bounds));

    /// <summary>Stores the bounds of a node that were computed before.</summary>
    public void Set(int level, int row, int column, NodeBounds bounds) => _stores[level].Set(row, column, bounds);

    /// <summary>The cap that holds the directions of all facets of a node.</summary>
    public SphericalCap CapOf(int level, int row, int column) =>
        _plane is null ? GeometryOf(level).CapOf(row, column) : _plane.CapOf(Layout.Cells(level, row, column));

    /// <summary>The cap that holds the directions of all facets of a rectangle of cells.</summary>
    public SphericalCap CapOf(CellRange cells) => _plane?.CapOf(cells) ?? MeshBounds.CapOf(cells, Layout.Lines, Layout.Samples);

    /// <summary>The box that holds all facets of a node whose vertex radii lie within bounds (m).</summary>
    public NodeBox BoxOf(int level, int row, int column, double minRadius, double maxRadius) => _plane is null
        ? GeometryOf(level).BoxOf(row, column, minRadius, maxRadius)
        : _plane.BoxOf(Layout.Cells(level, row, column), minRadius, maxRadius);

    /// <summary>
    /// Makes a node from known bounds and a cap. The bounds are widened because facets sag below their vertices and the lattice moves the
    /// vertices.
    /// </summary>
    public TerrainNode NodeOf(SphericalCap cap, NodeBounds bounds) => new(
        cap, (bounds.Min * _sagitta) - Tolerances.VertexLattice, bounds.Max + Tolerances.VertexLattice, bounds.MaxSlope);

    private bool TryUnite(int level, int row, int column, bool reads, out NodeBounds union)
    {
        union = NodeBounds.Empty;
        NodeRange children = Layout.ChildrenOf(level, row, column);
        bool isFetched = !reads;
        for (int childRow = children.FirstRow; childRow < children.EndRow; childRow++)
        {
            for (int childColumn = children.FirstColumn; childColumn < children.EndColumn; childColumn++)
            {
                if (!TryGetKnown(level - 1, childRow, childColumn, out NodeBounds child))
                {
                    if (!reads)
                    {
                        return false;
                    }

                    if (!isFetched)
                    {
                        Prefetch(Layout.Cells(level, row, column));
                        isFetched = true;
                    }

                    child = Of(level - 1, childRow, childColumn);
                }

                union = NodeBounds.Union(union, child);
            }
        }

        Set(level, row, column, union);
        return true;
    }

    private void Prefetch(CellRange cells)
    {
        if ((long)cells.Lines * cells.Samples is >= MinSamplesFetched and <= MaxSamplesFetched)
        {
            _mesh!.Prefetch(cells);
        }
    }

    private NodeGeometry GeometryOf(int level) => Volatile.Read(ref _geometries[level]) ?? NewGeometry(level);

    private NodeGeometry NewGeometry(int level)
    {
        NodeGeometry made = new(Layout, level);
        return Interlocked.CompareExchange(ref _geometries[level], made, null) ?? made;
    }
}
