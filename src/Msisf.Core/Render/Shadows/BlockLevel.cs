using Msisf.Core.Mesh;
using Msisf.Core.Mesh.Bounds;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Square groups of blocks of one size: where they lie, and their bounds as far as they are known. Safe for several threads.
/// </summary>
internal sealed class BlockLevel
{
    private readonly SineCosine[] _latitudes;
    private readonly SineCosine[] _longitudes;
    private readonly SineCosine[] _capRadii;
    private readonly RowOfGroups?[] _rows;

    /// <summary>Places the groups.</summary>
    /// <param name="mesh">The facets.</param>
    /// <param name="edge">Blocks to a group's edge; groups at the south pole and at longitude 360 degrees may have fewer.</param>
    public BlockLevel(FacetMesh mesh, int edge)
    {
        Edge = edge;
        Rows = (CellBlock.RowsOf(mesh) + edge - 1) / edge;
        Columns = (CellBlock.ColumnsOf(mesh) + edge - 1) / edge;
        _latitudes = new SineCosine[Rows];
        _capRadii = new SineCosine[Rows];
        _longitudes = new SineCosine[Columns];
        _rows = new RowOfGroups?[Rows];
        int size = edge * CellBlock.Size;
        for (int row = 0; row < Rows; row++)
        {
            // The caps of the first column do for the last one too, which is no wider.
            CellRange cells = new((row * size) - 1, Math.Min(((row + 1) * size) - 1, mesh.Lines), 0, Math.Min(size, mesh.Samples));
            SphericalCap cap = MeshBounds.CapOf(cells, mesh.Lines, mesh.Samples);
            _latitudes[row] = SineCosineOf(MeshBounds.CentreLatitude(cells, mesh.Lines));
            _capRadii[row] = new SineCosine(cap.SinRadius, cap.CosRadius);
        }

        for (int column = 0; column < Columns; column++)
        {
            CellRange cells = new(0, 1, column * size, Math.Min((column + 1) * size, mesh.Samples));
            _longitudes[column] = SineCosineOf(MeshBounds.CentreLongitude(cells, mesh.Samples));
        }
    }

    /// <summary>Blocks to a group's edge.</summary>
    public int Edge { get; }

    /// <summary>Rows of groups.</summary>
    public int Rows { get; }

    /// <summary>Groups a row.</summary>
    public int Columns { get; }

    /// <summary>Holds all facets of a group.</summary>
    public SphericalCap CapOf(int row, int column)
    {
        SineCosine latitude = _latitudes[row];
        SineCosine longitude = _longitudes[column];
        Vector3D centre = new(latitude.Cosine * longitude.Cosine, latitude.Cosine * longitude.Sine, latitude.Sine);
        return new SphericalCap(centre, _capRadii[row].Cosine, _capRadii[row].Sine);
    }

    /// <summary>The union of the bounds of a group's blocks, if it was noted.</summary>
    public bool TryGetBounds(int row, int column, out BlockBounds bounds)
    {
        RowOfGroups? groups = Volatile.Read(ref _rows[row]);
        bool isKnown = groups is not null && Volatile.Read(ref groups.IsKnown[column]);
        bounds = isKnown ? groups!.Bounds[column] : default;
        return isKnown;
    }

    /// <summary>Keeps the union of the bounds of a group's blocks.</summary>
    public void Note(int row, int column, BlockBounds bounds)
    {
        RowOfGroups groups = Volatile.Read(ref _rows[row]) ?? NewRow(row);
        groups.Bounds[column] = bounds; // two threads may both note it: they note the same
        Volatile.Write(ref groups.IsKnown[column], true);
    }

    private RowOfGroups NewRow(int row)
    {
        RowOfGroups made = new(Columns);
        return Interlocked.CompareExchange(ref _rows[row], made, null) ?? made;
    }

    private static SineCosine SineCosineOf(double angle)
    {
        (double sine, double cosine) = Math.SinCos(angle);
        return new SineCosine(sine, cosine);
    }

    private sealed class RowOfGroups(int columns)
    {
        public BlockBounds[] Bounds { get; } = new BlockBounds[columns];

        public bool[] IsKnown { get; } = new bool[columns];
    }
}
