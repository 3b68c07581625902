using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Draws a block's cells into a band of the picture, eight at a time. Cells that hold no pixel centre fall through; small ones are tested
/// against their pixels together, each cell with its own pixel; large ones are filled one by one.
/// </summary>
/// <remarks>
/// Whether a pixel lies in a facet is told by the signs of its edges, (a - p) x (b - p), without FMA: the same edge run through the other
/// way has exactly the opposite value, and zero counts as inside, so no pixel falls between two facets.
/// </remarks>
internal sealed class CellSieve
{
    private const int Lanes = 8;
    private const int Stride = ProjectedBlock.Stride;

    /// <summary>px: a wider or higher cell is filled row by row.</summary>
    private const double SmallExtent = 8.0;

    private readonly FacetPlanes _planes = new();
    private readonly CrossingCells _crossing = new();
    private readonly double[] _parameters = new double[Lanes];
    private readonly double[] _pixels = new double[Lanes];
    private PictureView _view = null!;
    private double _turnedArea;

    /// <summary>Takes a frame's camera.</summary>
    public void Begin(PictureView view)
    {
        _view = view;
        _planes.Begin(view);
        _crossing.Begin(view);

        // Rounding of products of coordinates up to the limit: facets whose area is not certain to be negative stay.
        _turnedArea = Math.ScaleB(view.CoordinateLimit * view.CoordinateLimit, -50);
    }

    /// <summary>Draws the cells of a block that is in front of the camera; returns how many were looked at.</summary>
    public long Draw(ProjectedBlock block, Band band)
    {
        CellRange cells = block.Vertices.Cells;
        int samples = block.Vertices.Samples - 1;
        long sieved = 0;
        for (int line = 0; line < block.Vertices.Lines - 1; line++)
        {
            if (!block.Touches(line, band.FirstRow, band.LastRow))
            {
                continue;
            }

            sieved += samples;
            int cellLine = cells.FirstLine + line;
            uint halves = HalvesOf(block, cellLine);
            for (int sample = 0; sample < samples; sample += Lanes)
            {
                uint lanes = samples - sample >= Lanes ? 0xffu : (1u << (samples - sample)) - 1;
                _planes.MoveTo(cellLine, cells.FirstSample + sample);
                DrawEight(block, (line * Stride) + sample, lanes, halves, band);
            }
        }

        return sieved;
    }

    /// <summary>Draws the cells of any block one by one; returns how many were looked at.</summary>
    public long DrawCrossing(ProjectedBlock block, Band band)
    {
        CellRange cells = block.Vertices.Cells;
        int lines = block.Vertices.Lines - 1;
        int samples = block.Vertices.Samples - 1;
        for (int line = 0; line < lines; line++)
        {
            int cellLine = cells.FirstLine + line;
            for (int sample = 0; sample < samples; sample++)
            {
                int index = (line * Stride) + sample;
                _planes.MoveTo(cellLine, cells.FirstSample + sample);
                for (uint halves = HalvesOf(block, cellLine); halves != 0; halves &= halves - 1)
                {
                    int half = BitOperations.TrailingZeroCount(halves);
                    DrawCrossing(block, index, half, cellLine, (2 * (cells.FirstSample + sample)) + half, band);
                }
            }
        }

        return lines * samples;
    }

    private void DrawCrossing(ProjectedBlock block, int index, int half, int cellLine, int sampleAndHalf, Band band)
    {
        int second = index + Second(half);
        int third = index + Third(half);
        if (block.IsUsable(index, _view) && block.IsUsable(second, _view) && block.IsUsable(third, _view))
        {
            FillFacet(block, index, 0, half, band);
        }
        else
        {
            _crossing.Draw(block, index, second, third, cellLine, sampleAndHalf, band);
        }
    }

    private void DrawEight(ProjectedBlock block, int index, uint lanes, uint halves, Band band)
    {
        ref double x = ref Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(block.X), index);
        ref double y = ref Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(block.Y), index);
        Vector512<double> xNorthWest = Vector512.LoadUnsafe(ref x);
        Vector512<double> xNorthEast = Vector512.LoadUnsafe(ref x, 1);
        Vector512<double> xSouthWest = Vector512.LoadUnsafe(ref x, Stride);
        Vector512<double> xSouthEast = Vector512.LoadUnsafe(ref x, Stride + 1);
        Vector512<double> yNorthWest = Vector512.LoadUnsafe(ref y);
        Vector512<double> yNorthEast = Vector512.LoadUnsafe(ref y, 1);
        Vector512<double> ySouthWest = Vector512.LoadUnsafe(ref y, Stride);
        Vector512<double> ySouthEast = Vector512.LoadUnsafe(ref y, Stride + 1);

        Vector512<double> left = Vector512.MinNative(Vector512.MinNative(xNorthWest, xNorthEast), Vector512.MinNative(xSouthWest, xSouthEast));
        Vector512<double> right = Vector512.MaxNative(Vector512.MaxNative(xNorthWest, xNorthEast), Vector512.MaxNative(xSouthWest, xSouthEast));
        Vector512<double> top = Vector512.MinNative(Vector512.MinNative(yNorthWest, yNorthEast), Vector512.MinNative(ySouthWest, ySouthEast));
        Vector512<double> bottom = Vector512.MaxNative(Vector512.MaxNative(yNorthWest, yNorthEast), Vector512.MaxNative(ySouthWest, ySouthEast));
        Vector512<double> firstColumn = Vector512.MaxNative(Vector512.Ceiling(left), Vector512<double>.Zero);
        Vector512<double> lastColumn = Vector512.MinNative(Vector512.Floor(right), Vector512.Create(band.Width - 1.0));
        Vector512<double> firstRow = Vector512.MaxNative(Vector512.Ceiling(top), Vector512.Create((double)band.FirstRow));
        Vector512<double> lastRow = Vector512.MinNative(Vector512.Floor(bottom), Vector512.Create((double)band.LastRow));

        Vector512<double> diagonalX = xSouthEast - xNorthWest;
        Vector512<double> diagonalY = ySouthEast - yNorthWest;
        Vector512<double> southWestArea = ((xSouthWest - xNorthWest) * diagonalY) - (diagonalX * (ySouthWest - yNorthWest));
        Vector512<double> northEastArea = (diagonalX * (yNorthEast - yNorthWest)) - ((xNorthEast - xNorthWest) * diagonalY);
        lanes &= (uint)(Vector512.LessThanOrEqual(firstColumn, lastColumn)
            & Vector512.LessThanOrEqual(firstRow, lastRow)
            & Vector512.LessThanOrEqual(Vector512.MinNative(southWestArea, northEastArea), Vector512.Create(_turnedArea))).ExtractMostSignificantBits();
        if (lanes == 0)
        {
            return;
        }

        uint large = lanes & (uint)Vector512.GreaterThan(
            Vector512.MaxNative(right - left, bottom - top), Vector512.Create(SmallExtent)).ExtractMostSignificantBits();
        uint rows = lanes & ~large;
        Vector512<double> row = firstRow;
        while (rows != 0)
        {
            Vector512<double> downNorthWest = yNorthWest - row;
            Vector512<double> downNorthEast = yNorthEast - row;
            Vector512<double> downSouthWest = ySouthWest - row;
            Vector512<double> downSouthEast = ySouthEast - row;
            Vector512<double> column = firstColumn;
            uint active = rows;
            do
            {
                Vector512<double> acrossNorthWest = xNorthWest - column;
                Vector512<double> acrossNorthEast = xNorthEast - column;
                Vector512<double> acrossSouthWest = xSouthWest - column;
                Vector512<double> acrossSouthEast = xSouthEast - column;
                Vector512<double> diagonal = (acrossNorthWest * downSouthEast) - (acrossSouthEast * downNorthWest);
                Vector512<double> west = (acrossNorthWest * downSouthWest) - (acrossSouthWest * downNorthWest);
                Vector512<double> south = (acrossSouthWest * downSouthEast) - (acrossSouthEast * downSouthWest);
                Vector512<double> east = (acrossSouthEast * downNorthEast) - (acrossNorthEast * downSouthEast);
                Vector512<double> north = (acrossNorthEast * downNorthWest) - (acrossNorthWest * downNorthEast);
                uint southWest = active & (uint)Vector512.LessThanOrEqual(
                    Vector512.MaxNative(Vector512.MaxNative(west, south), -diagonal), Vector512<double>.Zero).ExtractMostSignificantBits();
                uint northEast = active & (uint)Vector512.LessThanOrEqual(
                    Vector512.MaxNative(Vector512.MaxNative(east, north), diagonal), Vector512<double>.Zero).ExtractMostSignificantBits();
                if (southWest != 0 && (halves & 1) != 0)
                {
                    Commit(block, index, 0, southWest, column, row, band);
                }

                if (northEast != 0 && (halves & 2) != 0)
                {
                    Commit(block, index, 1, northEast, column, row, band);
                }

                column += Vector512<double>.One;
                active &= (uint)Vector512.LessThanOrEqual(column, lastColumn).ExtractMostSignificantBits();
            }
            while (active != 0);

            row += Vector512<double>.One;
            rows &= (uint)Vector512.LessThanOrEqual(row, lastRow).ExtractMostSignificantBits();
        }

        for (; large != 0; large &= large - 1)
        {
            int lane = BitOperations.TrailingZeroCount(large);
            for (uint half = halves; half != 0; half &= half - 1)
            {
                FillFacet(block, index, lane, BitOperations.TrailingZeroCount(half), band);
            }
        }
    }

    private void Commit(ProjectedBlock block, int index, int half, uint lanes, Vector512<double> column, Vector512<double> row, Band band)
    {
        _planes.Require(block, index, half);
        ref double parameters = ref MemoryMarshal.GetArrayDataReference(_parameters);
        ref double pixels = ref MemoryMarshal.GetArrayDataReference(_pixels);
        _planes.InverseParameters(half, column, row).StoreUnsafe(ref parameters);
        (((row - Vector512.Create((double)band.FirstRow)) * Vector512.Create((double)band.Stride)) + column).StoreUnsafe(ref pixels);
        ref double nearest = ref MemoryMarshal.GetArrayDataReference(band.InverseParameters);
        ref int facets = ref MemoryMarshal.GetArrayDataReference(band.Facets);
        for (; lanes != 0; lanes &= lanes - 1)
        {
            int lane = BitOperations.TrailingZeroCount(lanes);
            int pixel = (int)Unsafe.Add(ref pixels, lane);
            double parameter = Unsafe.Add(ref parameters, lane);
            if (parameter > Unsafe.Add(ref nearest, pixel))
            {
                Unsafe.Add(ref nearest, pixel) = parameter;
                Unsafe.Add(ref facets, pixel) = _planes.NumberIn(band, half, lane);
            }
        }
    }

    private void FillFacet(ProjectedBlock block, int index, int lane, int half, Band band)
    {
        (double X, double Y) a = At(block, index + lane);
        (double X, double Y) b = At(block, index + lane + Second(half));
        (double X, double Y) c = At(block, index + lane + Third(half));
        PixelRange pixels = PixelRange.Within(
            Math.Min(a.X, Math.Min(b.X, c.X)),
            Math.Max(a.X, Math.Max(b.X, c.X)),
            Math.Min(a.Y, Math.Min(b.Y, c.Y)),
            Math.Max(a.Y, Math.Max(b.Y, c.Y)),
            band);
        double area = ((b.X - a.X) * (c.Y - a.Y)) - ((c.X - a.X) * (b.Y - a.Y));
        if (!pixels.IsEmpty && area <= _turnedArea)
        {
            _planes.Require(block, index, half);
            ProjectedEdges edges = new(a, b, c);
            FacetFill.Fill(ref edges, _planes.Plane(half, lane), pixels, _planes.Record(half, lane), band);
        }
    }

    /// <summary>From a cell's north-western vertex, which comes first, to the second corner of a facet.</summary>
    private static int Second(int half) => Stride + half;

    /// <summary>To the third corner.</summary>
    private static int Third(int half) => 1 + ((1 - half) * Stride);

    /// <summary>A fan's cells have one facet: at the north pole the south-western one, at the south pole the other.</summary>
    private static uint HalvesOf(ProjectedBlock block, int cellLine) => cellLine < 0 ? 1u : cellLine == block.LastCellLine ? 2u : 3u;

    private static (double X, double Y) At(ProjectedBlock block, int index) => (block.X[index], block.Y[index]);
}
