using Msisf.Core.Mesh;
using Msisf.Core.Mesh.Bounds;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Where squares of 2^level x 2^level blocks lie as seen from the Moon's centre. The last row and column may have less of the surface than
/// their geometry says.
/// </summary>
internal sealed class BlockLevel
{
    private readonly RowGeometry[] _rows;
    private readonly SineCosine[] _longitudes;

    public BlockLevel(FacetMesh mesh, int level)
    {
        int size = CellBlock.Size << level;
        _rows = new RowGeometry[RowsAt(CellBlock.RowsOf(mesh), level)];
        _longitudes = new SineCosine[RowsAt(CellBlock.ColumnsOf(mesh), level)];
        for (int row = 0; row < _rows.Length; row++)
        {
            _rows[row] = new RowGeometry(new CellRange((row * size) - 1, Math.Min((row + 1) * size, mesh.Lines + 1) - 1, 0, size), mesh);
        }

        for (int column = 0; column < _longitudes.Length; column++)
        {
            CellRange cells = new(0, 0, column * size, (column + 1) * size);
            (double sine, double cosine) = Math.SinCos(MeshBounds.CentreLongitude(cells, mesh.Samples));
            _longitudes[column] = new SineCosine(sine, cosine);
        }
    }

    /// <summary>Rows of squares.</summary>
    public int Rows => _rows.Length;

    /// <summary>Columns of squares.</summary>
    public int Columns => _longitudes.Length;

    /// <summary>Rows or columns of squares for so many of blocks.</summary>
    public static int RowsAt(int blocks, int level) => (blocks + (1 << level) - 1) >> level;

    /// <summary>The box that holds all facets of a square whose vertex radii lie within bounds.</summary>
    /// <param name="row">Row of the square.</param>
    /// <param name="column">Column of the square.</param>
    /// <param name="minRadius">m.</param>
    /// <param name="maxRadius">m.</param>
    public BlockBox Box(int row, int column, double minRadius, double maxRadius)
    {
        ref readonly RowGeometry geometry = ref _rows[row];
        SineCosine longitude = _longitudes[column];
        SineCosine latitude = geometry.Latitude;
        Vector3D up = new(latitude.Cosine * longitude.Cosine, latitude.Cosine * longitude.Sine, latitude.Sine);
        Vector3D east = new(-longitude.Sine, longitude.Cosine, 0.0);
        Vector3D north = new(-latitude.Sine * longitude.Cosine, -latitude.Sine * longitude.Sine, latitude.Cosine);
        double highest = maxRadius + Tolerances.VertexLattice;
        double lowest = (minRadius - Tolerances.VertexLattice) * geometry.CapRadius.Cosine;
        return new BlockBox(
            up,
            geometry.CapRadius,
            0.5 * (highest + lowest),
            (0.5 * (highest - lowest)) * up,
            (highest * geometry.HalfWidth) * east,
            (highest * geometry.HalfHeight) * north);
    }

    private readonly struct RowGeometry
    {
        public RowGeometry(CellRange cells, FacetMesh mesh)
        {
            double latitude = MeshBounds.CentreLatitude(cells, mesh.Lines);
            (double sine, double cosine) = Math.SinCos(latitude);
            Latitude = new SineCosine(sine, cosine);
            SphericalCap cap = MeshBounds.CapOf(cells, mesh.Lines, mesh.Samples);
            CapRadius = new SineCosine(cap.SinRadius, cap.CosRadius);

            double north = FacetMesh.Latitude(cells.FirstLine, mesh.Lines);
            double south = FacetMesh.Latitude(cells.EndLine, mesh.Lines);
            double maxCosine = north > 0.0 && south < 0.0 ? 1.0 : Math.Max(Math.Cos(north), Math.Cos(south));
            double halfLongitude = Math.Min(0.5 * Math.PI, (cells.EndSample - cells.FirstSample) * Math.PI / mesh.Samples);
            double bulge = maxCosine * Math.Abs(sine) * (1.0 - Math.Cos(halfLongitude)); // parallels are no great circles
            HalfWidth = Tolerances.CapRadius + (maxCosine * Math.Sin(halfLongitude));
            HalfHeight = Tolerances.CapRadius + Math.Sin(0.5 * (north - south)) + bulge;
        }

        /// <summary>Of the middle.</summary>
        public SineCosine Latitude { get; }

        /// <summary>Angle from the middle to the farthest corner.</summary>
        public SineCosine CapRadius { get; }

        /// <summary>Half of the extent to the east, parts of the radius.</summary>
        public double HalfWidth { get; }

        /// <summary>Half of the extent to the north, parts of the radius.</summary>
        public double HalfHeight { get; }
    }
}
