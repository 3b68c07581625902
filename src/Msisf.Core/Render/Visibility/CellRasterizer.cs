using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Draws a block's cells into a band of the image, eight at a time. Cells that hold no pixel centre are dropped. Small cells are tested
/// together, each lane with a pixel of its own cell. Wide cells are filled one by one.
/// </summary>
/// <remarks>
/// The signs of the <see cref="CellEdges"/> tell whether a pixel lies in a facet; they leave no gap between two facets. The edge values are
/// also the weights of the corners, by which the inverse depth, which is linear in the image, is interpolated.
/// </remarks>
internal sealed class CellRasterizer
{
    private const int Lanes = 8;

    /// <summary>
    /// px: cells whose mean width over their rows is more than this are filled row by row. Measured: at this width both ways take the same
    /// time.
    /// </summary>
    private const double WideCell = 4.0;

    private readonly double[] _inverseDepths = new double[Lanes];
    private readonly double[] _pixels = new double[Lanes];
    private readonly double[] _sampleColumns = new double[Lanes];
    private readonly double[] _sampleRows = new double[Lanes];
    private readonly int[] _numbers = new int[2 * Lanes];
    private double _turnedArea;

    /// <summary>Prepares for a frame.</summary>
    public void Begin(ImageView view) => _turnedArea = view.BackFaceArea;

    /// <summary>Draws the cells of a block that is in front of the camera and returns the number of cells that were tested.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be drawn with unoptimised vectors
    public long Draw<TSamples>(ProjectedBlock block, Band band)
        where TSamples : struct, ISampleKind
    {
        double margin = TSamples.IsPixelCentre ? 0.0 : band.Margin;
        int samples = block.Vertices.Samples - 1;
        long sieved = 0;
        for (int line = 0; line < block.Vertices.Lines - 1; line++)
        {
            if (!block.Touches(line, band.Window.FirstRow - margin, band.Window.LastRow + margin))
            {
                continue;
            }

            sieved += samples;
            uint halves = block.HalvesOf(line);
            uint cells = block.Vertices.CellsOfLine(line);
            for (int sample = 0; sample < samples; sample += Lanes)
            {
                uint lanes = (cells >> sample) & (samples - sample >= Lanes ? 0xffu : (1u << (samples - sample)) - 1);
                DrawEight<TSamples>(block, (line * ProjectedBlock.Stride) + sample, lanes, halves, band);
            }
        }

        return sieved;
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void DrawEight<TSamples>(ProjectedBlock block, int index, uint lanes, uint halves, Band band)
        where TSamples : struct, ISampleKind
    {
        EightCells cells = new(block, index);
        Vector512<double> left = cells.Left;
        Vector512<double> right = cells.Right;
        Vector512<double> top = cells.Top;
        Vector512<double> bottom = cells.Bottom;
        if (!TSamples.IsPixelCentre)
        {
            Vector512<double> margin = Vector512.Create(band.Margin);
            left -= margin;
            right += margin;
            top -= margin;
            bottom += margin;
        }

        PixelRange window = band.Window;
        Vector512<double> firstColumn = Vector512.MaxNative(Vector512.Ceiling(left), Vector512.Create((double)window.FirstColumn));
        Vector512<double> lastColumn = Vector512.MinNative(Vector512.Floor(right), Vector512.Create((double)window.LastColumn));
        Vector512<double> firstRow = Vector512.MaxNative(Vector512.Ceiling(top), Vector512.Create((double)window.FirstRow));
        Vector512<double> lastRow = Vector512.MinNative(Vector512.Floor(bottom), Vector512.Create((double)window.LastRow));
        Vector512<double> southWestArea = cells.SouthWestArea;
        Vector512<double> northEastArea = cells.NorthEastArea;
        lanes &= Bits(Vector512.LessThanOrEqual(firstColumn, lastColumn)
            & Vector512.LessThanOrEqual(firstRow, lastRow)
            & Vector512.LessThanOrEqual(Vector512.MinNative(southWestArea, northEastArea), Vector512.Create(_turnedArea)));
        if (lanes == 0)
        {
            return;
        }

        uint wide = lanes & Bits(Vector512.GreaterThan(
            Vector512.Abs(southWestArea) + Vector512.Abs(northEastArea), Vector512.Create(2.0 * WideCell) * (bottom - top)));
        uint rows = lanes & ~wide;
        if (rows != 0)
        {
            Vector512.Create(Band.NotRecorded).StoreTo(_numbers, 0);
            bool isOverfull = (rows & Bits(Vector512.GreaterThan(lastColumn - firstColumn, Vector512<double>.One))) != 0;
            ShearedBounds box = isOverfull ? ShearedBounds.Along(cells, band.Margin) : ShearedBounds.Upright(left, right);
            for (Vector512<double> row = firstRow; rows != 0;)
            {
                (Vector512<double> begin, Vector512<double> end) = box.At(row);
                begin = Vector512.MaxNative(firstColumn, Vector512.Ceiling(begin));
                end = Vector512.MinNative(lastColumn, end);
                TestRow<TSamples>(block, cells, index, row, begin, end, rows, halves, band);
                row += Vector512<double>.One;
                rows &= Bits(Vector512.LessThanOrEqual(row, lastRow));
            }
        }

        for (; wide != 0; wide &= wide - 1)
        {
            CellFill.Draw<TSamples>(block, index + BitOperations.TrailingZeroCount(wide), halves, band);
        }
    }

    /// <summary>
    /// Tests each cell against the pixels of one row, from its first to its last column; each cell has its own row and columns.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void TestRow<TSamples>(
        ProjectedBlock block,
        EightCells cells,
        int index,
        Vector512<double> row,
        Vector512<double> column,
        Vector512<double> end,
        uint rows,
        uint halves,
        Band band)
        where TSamples : struct, ISampleKind
    {
        Vector512<double> southWestMask = MaskOf(halves & FacetCorners.SouthWestHalf);
        Vector512<double> northEastMask = MaskOf(halves & FacetCorners.NorthEastHalf);
        Vector512<double> downNorthWest = cells.Y(0) - row;
        Vector512<double> downNorthEast = cells.Y(FacetCorners.NorthEast) - row;
        Vector512<double> downSouthWest = cells.Y(FacetCorners.SouthWest) - row;
        Vector512<double> downSouthEast = cells.Y(FacetCorners.SouthEast) - row;
        uint active = rows & Bits(Vector512.LessThanOrEqual(column, end));
        while (active != 0)
        {
            Vector512<double> sample = column;
            if (!TSamples.IsPixelCentre)
            {
                GatherSamples(PixelsOf(row, column, band), active, band);
                sample = ArrayLanes.Load(_sampleColumns, 0);
                Vector512<double> sampleRow = ArrayLanes.Load(_sampleRows, 0);
                downNorthWest = cells.Y(0) - sampleRow;
                downNorthEast = cells.Y(FacetCorners.NorthEast) - sampleRow;
                downSouthWest = cells.Y(FacetCorners.SouthWest) - sampleRow;
                downSouthEast = cells.Y(FacetCorners.SouthEast) - sampleRow;
            }

            Vector512<double> acrossNorthWest = cells.X(0) - sample;
            Vector512<double> acrossNorthEast = cells.X(FacetCorners.NorthEast) - sample;
            Vector512<double> acrossSouthWest = cells.X(FacetCorners.SouthWest) - sample;
            Vector512<double> acrossSouthEast = cells.X(FacetCorners.SouthEast) - sample;
            CellEdges edges = new(
                acrossNorthWest, downNorthWest, acrossNorthEast, downNorthEast, acrossSouthWest, downSouthWest, acrossSouthEast,
                downSouthEast);
            Vector512<double> inSouthWest = southWestMask & Vector512.LessThanOrEqual(edges.MaxOfSouthWest, Vector512<double>.Zero);
            Vector512<double> inNorthEast = northEastMask & Vector512.LessThanOrEqual(edges.MaxOfNorthEast, Vector512<double>.Zero);
            uint hits = active & Bits(inSouthWest | inNorthEast);
            if (hits != 0)
            {
                // A pixel in both facets is on the diagonal, where both have the same depth.
                Vector512<double> ofNorthWest = Vector512.ConditionalSelect(inSouthWest, edges.South, edges.East);
                Vector512<double> ofSouthEast = Vector512.ConditionalSelect(inSouthWest, edges.West, edges.North);
                Vector512<double> ofThird = Vector512.ConditionalSelect(inSouthWest, -edges.Diagonal, edges.Diagonal);
                Vector512<double> atThird = Vector512.ConditionalSelect(
                    inSouthWest, cells.InverseDepth(FacetCorners.SouthWest), cells.InverseDepth(FacetCorners.NorthEast));
                Vector512<double> weighted = (ofNorthWest * cells.InverseDepth(0))
                    + (ofSouthEast * cells.InverseDepth(FacetCorners.SouthEast))
                    + (ofThird * atThird);
                (weighted / (ofNorthWest + ofSouthEast + ofThird)).StoreTo(_inverseDepths, 0);
                if (TSamples.IsPixelCentre)
                {
                    PixelsOf(row, column, band).StoreTo(_pixels, 0);
                }

                Commit(block, index, hits, Bits(inSouthWest), band);
            }

            column += Vector512<double>.One;
            active &= Bits(Vector512.LessThanOrEqual(column, end));
        }
    }

    /// <summary>Index of each lane's pixel in the band.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> PixelsOf(Vector512<double> row, Vector512<double> column, Band band) =>
        ((row - Vector512.Create((double)band.FirstRow)) * Vector512.Create((double)band.Stride)) + column;

    /// <summary>Reads where the samples of the active lanes' pixels lie.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void GatherSamples(Vector512<double> pixels, uint active, Band band)
    {
        pixels.StoreTo(_pixels, 0);
        (double[] columns, double[] rows) = (band.SampleColumns, band.SampleRows);
        (double[] ofPixels, double[] sampleColumns, double[] sampleRows) = (_pixels, _sampleColumns, _sampleRows);
        for (; active != 0; active &= active - 1)
        {
            int lane = BitOperations.TrailingZeroCount(active);
            int pixel = (int)ArrayLanes.At(ofPixels, lane);
            ArrayLanes.At(sampleColumns, lane) = ArrayLanes.At(columns, pixel);
            ArrayLanes.At(sampleRows, lane) = ArrayLanes.At(rows, pixel);
        }
    }

    /// <summary>
    /// Writes the hit pixels at which the cells' facets are nearer than what was drawn before. A depth that is NaN is never nearer.
    /// </summary>
    private void Commit(ProjectedBlock block, int index, uint hits, uint southWest, Band band)
    {
        (double[] inverseDepths, double[] pixels, int[] numbers) = (_inverseDepths, _pixels, _numbers);
        (double[] nearest, int[] facets) = (band.InverseDepths, band.Facets);
        for (; hits != 0; hits &= hits - 1)
        {
            int lane = BitOperations.TrailingZeroCount(hits);
            int pixel = (int)ArrayLanes.At(pixels, lane);
            double inverseDepth = ArrayLanes.At(inverseDepths, lane);
            ref double before = ref ArrayLanes.At(nearest, pixel);
            if (inverseDepth > before)
            {
                int half = (int)(~southWest >> lane) & 1;
                ref int number = ref ArrayLanes.At(numbers, (2 * lane) + half);
                if (number == Band.NotRecorded)
                {
                    number = band.Records.Add(block, index + lane, half);
                }

                before = inverseDepth;
                ArrayLanes.At(facets, pixel) = number;
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static uint Bits(Vector512<double> mask) => (uint)mask.ExtractMostSignificantBits();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> MaskOf(uint half) => Vector512.Create(half != 0 ? -1L : 0L).AsDouble();
}
