using Msisf.Core.Numerics;
using Msisf.Core.Tiles;

namespace Msisf.Core.Mesh.Bounds;

/// <summary>
/// Bounds of the surface in blocks of equal size, a whole number of them to a tile's edge. Rows run from north to south, columns from
/// longitude 0 to the east, as lines and samples do.
/// </summary>
public sealed class SummaryLevel
{
    private readonly (double Sin, double Cos)[] _latitudes;
    private readonly (double Sin, double Cos)[] _longitudes;
    private readonly (double Sin, double Cos)[] _capRadii;
    private readonly double _sagitta;

    /// <summary>Takes the bounds.</summary>
    /// <param name="pixelsPerDegree">Samples a degree of the model.</param>
    /// <param name="subdivisions">Blocks to a tile's edge.</param>
    /// <param name="bounds">
    /// Row by row: minimum and maximum vertex radius in m, tangent of the steepest facet's slope; rounded outwards.
    /// </param>
    internal SummaryLevel(int pixelsPerDegree, int subdivisions, BlockBounds[] bounds)
    {
        Subdivisions = subdivisions;
        Bounds = bounds;
        TileCells = TileId.SizeDegrees * pixelsPerDegree;
        Lines = 180 * pixelsPerDegree;
        Samples = 360 * pixelsPerDegree;
        _sagitta = MeshBounds.SagittaFactor(pixelsPerDegree);
        _latitudes = new (double, double)[Rows];
        _capRadii = new (double, double)[Rows];
        _longitudes = new (double, double)[Columns];
        FillGeometry();
    }

    /// <summary>Blocks to a tile's edge.</summary>
    public int Subdivisions { get; }

    /// <summary>Rows of blocks from pole to pole.</summary>
    public int Rows => TileId.Rows * Subdivisions;

    /// <summary>Columns of blocks around the Moon.</summary>
    public int Columns => TileId.Columns * Subdivisions;

    /// <summary>Of each block, row by row.</summary>
    internal BlockBounds[] Bounds { get; }

    /// <summary>Cells to a tile's edge.</summary>
    internal int TileCells { get; }

    /// <summary>Lines of the model.</summary>
    internal int Lines { get; }

    private int Samples { get; }

    /// <summary>The block with its place and bounds.</summary>
    internal TerrainNode Node(int row, int column)
    {
        (double sinLatitude, double cosLatitude) = _latitudes[row];
        (double sinLongitude, double cosLongitude) = _longitudes[column];
        Vector3D centre = new(cosLatitude * cosLongitude, cosLatitude * sinLongitude, sinLatitude);
        BlockBounds bounds = Bounds[(row * Columns) + column];
        return new TerrainNode(
            new SphericalCap(centre, _capRadii[row].Cos, _capRadii[row].Sin),
            (bounds.Min * _sagitta) - Tolerances.VertexLattice,
            bounds.Max + Tolerances.VertexLattice,
            bounds.MaxSlope);
    }

    /// <summary>A tile's block with its place and bounds.</summary>
    /// <param name="tile">The tile.</param>
    /// <param name="block">
    /// Row of the block in its tile times <see cref="Subdivisions"/> plus its column; of the tiles themselves there is one block each.
    /// </param>
    internal TerrainNode NodeOf(TileId tile, int block = 0)
    {
        (int row, int column) = PlaceOf(tile, block);
        return Node(row, column);
    }

    /// <summary>Row and column of a tile's block; the numbers are those of <see cref="NodeOf"/>.</summary>
    internal (int Row, int Column) PlaceOf(TileId tile, int block)
    {
        (int row, int column) = int.DivRem(block, Subdivisions);
        return ((tile.RowFromNorth * Subdivisions) + row, (tile.Column * Subdivisions) + column);
    }

    /// <summary>Several neighbours of one row as one node.</summary>
    /// <param name="row">Row of blocks.</param>
    /// <param name="column">Westernmost block.</param>
    /// <param name="count">How many.</param>
    internal TerrainNode Node(int row, int column, int count)
    {
        if (count == 1)
        {
            return Node(row, column);
        }

        BlockBounds bounds = Bounds[(row * Columns) + column];
        for (int next = column + 1; next < column + count; next++)
        {
            bounds = BlockBounds.Union(bounds, Bounds[(row * Columns) + next]);
        }

        CellRange cells = Cells(row, column, count);
        SphericalCap cap = MeshBounds.CapOf(cells, Lines, Samples);
        return new TerrainNode(
            cap, (bounds.Min * _sagitta) - Tolerances.VertexLattice, bounds.Max + Tolerances.VertexLattice, bounds.MaxSlope);
    }

    /// <summary>The mesh cells of some neighbouring blocks of one row.</summary>
    internal CellRange Cells(int row, int column, int count = 1) =>
        new(row == 0 ? -1 : Start(row), Start(row + 1), Start(column), Start(column + count));

    /// <summary>Half of the minimum extent of a block as an angle; rad.</summary>
    internal double InnerRadius(int row)
    {
        return MeshBounds.InnerRadius(Cells(row, 0) with { EndSample = TileCells / Subdivisions }, Lines, Samples);
    }

    /// <summary>First line or sample of a row or column.</summary>
    internal int Start(int block) => ((block / Subdivisions) * TileCells) + (block % Subdivisions * TileCells / Subdivisions);

    private void FillGeometry()
    {
        for (int row = 0; row < Rows; row++)
        {
            CellRange cells = Cells(row, 0);
            _latitudes[row] = Math.SinCos(MeshBounds.CentreLatitude(cells, Lines));

            // Where a tile's cells can't be parted evenly some columns are a cell wider: all get the cap of those.
            int widest = (TileCells + Subdivisions - 1) / Subdivisions;
            SphericalCap cap = MeshBounds.CapOf(cells with { EndSample = widest }, Lines, Samples);
            _capRadii[row] = (cap.SinRadius, cap.CosRadius);
        }

        for (int column = 0; column < Columns; column++)
        {
            _longitudes[column] = Math.SinCos(MeshBounds.CentreLongitude(Cells(0, column), Samples));
        }
    }
}
