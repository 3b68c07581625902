namespace Msisf.Core.Surface;

/// <summary>
/// Directions and extents of the nodes of a level of a mesh of latitude and longitude as seen from the Moon's centre, independent of their
/// heights. Immutable.
/// </summary>
internal sealed class NodeGeometry
{
    private readonly RowGeometry[] _rows;
    private readonly SineCosine[] _longitudes;

    /// <summary>Computes the geometry of a level's nodes.</summary>
    public NodeGeometry(BoundsLayout layout, int level)
    {
        _longitudes = new SineCosine[layout.Columns(level)];
        int widest = 0;
        for (int column = 0; column < _longitudes.Length; column++)
        {
            CellRange cells = layout.Cells(level, 0, column);
            widest = Math.Max(widest, cells.EndSample - cells.FirstSample);
            _longitudes[column] = SineCosineOf(MeshBounds.CentreLongitude(cells, layout.Samples));
        }

        // Some columns are narrower than others: all get the extent of the widest one.
        _rows = new RowGeometry[layout.Rows(level)];
        for (int row = 0; row < _rows.Length; row++)
        {
            _rows[row] = new RowGeometry(
                layout.Cells(level, row, 0) with { FirstSample = 0, EndSample = widest }, layout.Lines, layout.Samples);
        }
    }

    /// <summary>The cap that holds the directions of all facets of a node.</summary>
    public SphericalCap CapOf(int row, int column) => new(DirectionOf(row, column), _rows[row].CapRadius.Cosine, _rows[row].CapRadius.Sine);

    /// <summary>The box that holds all facets of a node whose vertex radii lie within bounds.</summary>
    /// <param name="minRadius">Minimum vertex radius of the node, m.</param>
    /// <param name="maxRadius">Maximum vertex radius of the node, m.</param>
    public NodeBox BoxOf(int row, int column, double minRadius, double maxRadius)
    {
        ref readonly RowGeometry geometry = ref _rows[row];
        SineCosine longitude = _longitudes[column];
        SineCosine latitude = geometry.Latitude;
        Vector3D up = DirectionOf(row, column);
        Vector3D east = new(-longitude.Sine, longitude.Cosine, 0.0);
        Vector3D north = new(-latitude.Sine * longitude.Cosine, -latitude.Sine * longitude.Sine, latitude.Cosine);
        double highest = maxRadius + Tolerances.VertexLattice;
        double lowest = (minRadius - Tolerances.VertexLattice) * geometry.CapRadius.Cosine;
        OrientedBox box = new(
            (0.5 * (highest + lowest)) * up,
            (0.5 * (highest - lowest)) * up,
            (highest * geometry.HalfWidth) * east,
            (highest * geometry.HalfHeight) * north);
        return new NodeBox(up, geometry.CapRadius, box);
    }

    private static SineCosine SineCosineOf(double angle)
    {
        (double sine, double cosine) = Math.SinCos(angle);
        return new SineCosine(sine, cosine);
    }

    private Vector3D DirectionOf(int row, int column)
    {
        SineCosine latitude = _rows[row].Latitude;
        SineCosine longitude = _longitudes[column];
        return new Vector3D(latitude.Cosine * longitude.Cosine, latitude.Cosine * longitude.Sine, latitude.Sine);
    }

    private readonly struct RowGeometry
    {
        public RowGeometry(CellRange cells, int lines, int samples)
        {
            Latitude = SineCosineOf(MeshBounds.CentreLatitude(cells, lines));
            SphericalCap cap = MeshBounds.CapOf(cells, lines, samples);
            CapRadius = new SineCosine(cap.SinRadius, cap.CosRadius);

            double north = FacetMesh.Latitude(cells.FirstLine, lines);
            double south = FacetMesh.Latitude(cells.EndLine, lines);
            double maxCosine = north > 0.0 && south < 0.0 ? 1.0 : Math.Max(Math.Cos(north), Math.Cos(south));
            double halfLongitude = Math.Min(0.5 * Math.PI, cells.EndSample * Math.PI / samples);
            double bulge = maxCosine * Math.Abs(Latitude.Sine) * (1.0 - Math.Cos(halfLongitude)); // parallels are not great circles
            HalfWidth = Tolerances.CapRadius + (maxCosine * Math.Sin(halfLongitude));
            HalfHeight = Tolerances.CapRadius + Math.Sin(0.5 * (north - south)) + bulge;
        }

        /// <summary>Latitude of the node's middle.</summary>
        public SineCosine Latitude { get; }

        /// <summary>Angle from the middle to the farthest corner.</summary>
        public SineCosine CapRadius { get; }

        /// <summary>Half of the extent from west to east, as a fraction of the radius.</summary>
        public double HalfWidth { get; }

        /// <summary>Half of the extent from south to north, as a fraction of the radius.</summary>
        public double HalfHeight { get; }
    }
}
