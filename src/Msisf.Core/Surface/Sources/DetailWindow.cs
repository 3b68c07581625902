using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>A generated window as a grid; its heights are those of its lattice at its level. Safe for several threads.</summary>
internal sealed class DetailWindow : ITerrainGrid
{
    private const int Side = DetailTiles<double>.Side;

    private readonly DetailTiles<double> _tiles;
    private readonly WindowPlace _place;
    private readonly int _firstRow;
    private readonly int _firstColumn;
    private readonly int _columns;
    private readonly double[]?[] _known;

    /// <summary>Places a window; nothing is computed yet.</summary>
    /// <param name="tiles">Its heights.</param>
    /// <param name="place">Where the window lies.</param>
    public DetailWindow(IGroundDetail detail, DetailTiles<double> tiles, WindowPlace place)
    {
        (_tiles, _place) = (tiles, place);
        CellRange cells = place.Cells;
        ProductId = detail.Name;
        RadiusLimits = detail.RadiusLimits;
        Projection = place.Face.Map(place.Level, cells.FirstLine, cells.FirstSample);
        (Lines, Samples) = (cells.Lines + 1, cells.Samples + 1);
        _firstRow = TileOf(cells.FirstLine);
        _firstColumn = TileOf(cells.FirstSample);
        _columns = TileOf(cells.EndSample) - _firstColumn + 1;
        _known = new double[(TileOf(cells.EndLine) - _firstRow + 1) * _columns][];
    }

    /// <inheritdoc/>
    public string ProductId { get; }

    /// <inheritdoc/>
    public MapProjection Projection { get; }

    /// <inheritdoc/>
    public int Lines { get; }

    /// <inheritdoc/>
    public int Samples { get; }

    /// <inheritdoc/>
    public (double Min, double Max) RadiusLimits { get; }

    /// <inheritdoc/>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        int latticeLine = _place.Cells.FirstLine + line;
        int row = TileOf(latticeLine);
        int down = latticeLine - (row * Side);
        for (int done = 0; done < radii.Length;)
        {
            int sample = _place.Cells.FirstSample + firstSample + done;
            int column = TileOf(sample);
            int right = sample - (column * Side);
            int count = Math.Min(radii.Length - done, Side - right);
            ref double[]? known = ref _known[((row - _firstRow) * _columns) + column - _firstColumn];
            known ??= _tiles.Get(_place.Face, _place.Level, row, column);
            known.AsSpan((down * Side) + right, count).CopyTo(radii.Slice(done, count));
            done += count;
        }
    }

    private static int TileOf(int lattice) => lattice >> 6;
}
