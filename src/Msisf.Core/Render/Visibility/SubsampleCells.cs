using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Draws a block's cells into the further samples of a band. Each cell is tested against eight samples of a pixel at a time, with the edge
/// functions of <see cref="CellRasterizer"/>; cells whose box holds no pixel with samples are dropped.
/// </summary>
internal sealed class SubsampleCells
{
    private const int Lanes = 8;

    /// <summary>px: in cells that are wider, the columns of each row are found from the cell's sides.</summary>
    private const int WideCell = 4;

    private readonly double[] _limits = new double[4 * Lanes];
    private readonly NearPlaneCells _crossing = new();
    private ImageView _view = null!;

    /// <summary>Prepares for a projection.</summary>
    public void Begin(ImageView view)
    {
        _view = view;
        _crossing.Begin(view);
    }

    /// <summary>Draws the cells of a projected block.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would else be drawn with unoptimised vectors
    public void Draw(ProjectedBlock block, SubsampleBand band)
    {
        int samples = block.Vertices.Samples - 1;
        for (int line = 0; line < block.Vertices.Lines - 1; line++)
        {
            uint halves = block.HalvesOf(line);
            uint cells = block.Vertices.CellsOfLine(line);
            if (!block.IsInFront)
            {
                for (int sample = 0; sample < samples; sample++)
                {
                    DrawAnywhere(
                        block, (line * ProjectedBlock.Stride) + sample, (cells >> sample & 1) != 0 ? halves : 0, band);
                }
            }
            else if (block.Touches(line, band.Window.FirstRow - band.Margin, band.Window.LastRow + band.Margin))
            {
                for (int sample = 0; sample < samples; sample += Lanes)
                {
                    uint lanes = (cells >> sample) & (samples - sample >= Lanes ? 0xffu : (1u << (samples - sample)) - 1);
                    DrawEight(block, (line * ProjectedBlock.Stride) + sample, lanes, halves, band);
                }
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void DrawEight(ProjectedBlock block, int index, uint lanes, uint halves, SubsampleBand band)
    {
        EightCells cells = new(block, index);
        PixelRange window = band.Window;
        Vector512<double> margin = Vector512.Create(band.Margin);
        Vector512<double> firstColumn = Vector512.MaxNative(
            Vector512.Ceiling(cells.Left - margin), Vector512.Create((double)window.FirstColumn));
        Vector512<double> lastColumn = Vector512.MinNative(
            Vector512.Floor(cells.Right + margin), Vector512.Create((double)window.LastColumn));
        Vector512<double> firstRow = Vector512.MaxNative(Vector512.Ceiling(cells.Top - margin), Vector512.Create((double)window.FirstRow));
        Vector512<double> lastRow = Vector512.MinNative(Vector512.Floor(cells.Bottom + margin), Vector512.Create((double)window.LastRow));
        lanes &= (uint)(Vector512.LessThanOrEqual(firstColumn, lastColumn)
            & Vector512.LessThanOrEqual(firstRow, lastRow)
            & Vector512.LessThanOrEqual(
                Vector512.MinNative(cells.SouthWestArea, cells.NorthEastArea), Vector512.Create(_view.BackFaceArea)))
            .ExtractMostSignificantBits();
        if (lanes == 0)
        {
            return;
        }

        firstColumn.StoreTo(_limits, 0);
        lastColumn.StoreTo(_limits, Lanes);
        firstRow.StoreTo(_limits, 2 * Lanes);
        lastRow.StoreTo(_limits, 3 * Lanes);
        for (; lanes != 0; lanes &= lanes - 1)
        {
            int lane = BitOperations.TrailingZeroCount(lanes);
            PixelRange pixels = new(
                (int)_limits[lane], (int)_limits[Lanes + lane], (int)_limits[(2 * Lanes) + lane], (int)_limits[(3 * Lanes) + lane]);
            if (band.HasSamples(pixels))
            {
                DrawCell(block, index + lane, halves, pixels, band);
            }
        }
    }

    /// <summary>Draws a cell of a block that is not wholly in front of the camera.</summary>
    private void DrawAnywhere(ProjectedBlock block, int index, uint halves, SubsampleBand band)
    {
        if (block.IsUsable(index, _view)
            && block.IsUsable(index + FacetCorners.NorthEast, _view)
            && block.IsUsable(index + FacetCorners.SouthWest, _view)
            && block.IsUsable(index + FacetCorners.SouthEast, _view))
        {
            CellCorner a = new(block, index);
            CellCorner b = new(block, index + FacetCorners.NorthEast);
            CellCorner c = new(block, index + FacetCorners.SouthWest);
            CellCorner d = new(block, index + FacetCorners.SouthEast);
            PixelRange box = PixelRange.Within(
                Math.Min(Math.Min(a.X, b.X), Math.Min(c.X, d.X)) - band.Margin,
                Math.Max(Math.Max(a.X, b.X), Math.Max(c.X, d.X)) + band.Margin,
                Math.Min(Math.Min(a.Y, b.Y), Math.Min(c.Y, d.Y)) - band.Margin,
                Math.Max(Math.Max(a.Y, b.Y), Math.Max(c.Y, d.Y)) + band.Margin,
                band.Window);
            if (!box.IsEmpty && band.HasSamples(box))
            {
                DrawCell(block, index, halves, box, band);
            }

            return;
        }

        for (uint left = halves; left != 0; left &= left - 1)
        {
            int half = BitOperations.TrailingZeroCount(left);
            if (_crossing.TryFind(block, index, half, band.Window, band.Margin, out HomogeneousEdges edges, out PixelRange pixels)
                && band.HasSamples(pixels))
            {
                DrawCrossing(block, index, half, edges, pixels, band);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void DrawCell(ProjectedBlock block, int index, uint halves, in PixelRange pixels, SubsampleBand band)
    {
        CellCorner northWest = new(block, index);
        CellCorner northEast = new(block, index + FacetCorners.NorthEast);
        CellCorner southWest = new(block, index + FacetCorners.SouthWest);
        CellCorner southEast = new(block, index + FacetCorners.SouthEast);
        bool isWide = pixels.LastColumn - pixels.FirstColumn >= WideCell;
        CellSides sides = isWide ? new CellSides(northWest, northEast, southWest, southEast) : default;
        Vector512<double> southWestMask = Vector512.Create((halves & FacetCorners.SouthWestHalf) != 0 ? -1L : 0L).AsDouble();
        Vector512<double> northEastMask = Vector512.Create((halves & FacetCorners.NorthEastHalf) != 0 ? -1L : 0L).AsDouble();
        CellWinners winners = new();
        ReadOnlySpan<double> sampleColumns = band.Columns;
        ReadOnlySpan<double> sampleRows = band.Rows;
        Span<double> nearest = band.InverseDepths;
        int[] facets = band.Facets;
        for (int row = pixels.FirstRow; row <= pixels.LastRow; row++)
        {
            int begin = pixels.FirstColumn;
            int end = pixels.LastColumn;
            if (isWide)
            {
                (double first, double last) = sides.Within(row, band.Margin);
                begin = (int)Math.Max(begin, Math.Ceiling(first));
                end = (int)Math.Min(end, last);
            }

            for (int column = begin; column <= end; column++)
            {
                int vectors = band.VectorsOf(column, row);
                if (vectors == 0)
                {
                    continue;
                }

                int start = band.Starts[band.IndexOf(column, row)];
                for (int sample = start; sample < start + (vectors * Lanes); sample += Lanes)
                {
                    Vector512<double> x = ArrayLanes.Load(sampleColumns, sample);
                    Vector512<double> y = ArrayLanes.Load(sampleRows, sample);
                    CellEdges edges = new(
                        Vector512.Create(northWest.X) - x,
                        Vector512.Create(northWest.Y) - y,
                        Vector512.Create(northEast.X) - x,
                        Vector512.Create(northEast.Y) - y,
                        Vector512.Create(southWest.X) - x,
                        Vector512.Create(southWest.Y) - y,
                        Vector512.Create(southEast.X) - x,
                        Vector512.Create(southEast.Y) - y);
                    Vector512<double> inSouthWest = southWestMask & Vector512.LessThanOrEqual(edges.MaxOfSouthWest, Vector512<double>.Zero);
                    Vector512<double> inNorthEast = northEastMask & Vector512.LessThanOrEqual(edges.MaxOfNorthEast, Vector512<double>.Zero);
                    if ((inSouthWest | inNorthEast) == Vector512<double>.Zero)
                    {
                        continue;
                    }

                    // As in CellRasterizer: a sample in both facets is on the diagonal, where both have the same depth.
                    Vector512<double> ofNorthWest = Vector512.ConditionalSelect(inSouthWest, edges.South, edges.East);
                    Vector512<double> ofSouthEast = Vector512.ConditionalSelect(inSouthWest, edges.West, edges.North);
                    Vector512<double> ofThird = Vector512.ConditionalSelect(inSouthWest, -edges.Diagonal, edges.Diagonal);
                    Vector512<double> atThird = Vector512.ConditionalSelect(
                        inSouthWest, Vector512.Create(southWest.InverseDepth), Vector512.Create(northEast.InverseDepth));
                    Vector512<double> inverseDepth = ((ofNorthWest * northWest.InverseDepth) + (ofSouthEast * southEast.InverseDepth)
                        + (ofThird * atThird)) / (ofNorthWest + ofSouthEast + ofThird);
                    Vector512<double> before = ArrayLanes.Load(nearest, sample);
                    Vector512<double> wins = (inSouthWest | inNorthEast) & Vector512.GreaterThan(inverseDepth, before);
                    if (wins == Vector512<double>.Zero)
                    {
                        continue;
                    }

                    Vector512.ConditionalSelect(wins, inverseDepth, before).StoreTo(nearest, sample);
                    winners.Store(band.Records, block, index, wins, inSouthWest, ref ArrayLanes.At(facets, sample));
                }
            }
        }
    }

    /// <summary>Draws a facet with corners that cannot be projected.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void DrawCrossing(
        ProjectedBlock block, int index, int half, in HomogeneousEdges edges, in PixelRange pixels, SubsampleBand band)
    {
        block.Record(index, half, out FacetRecord record);
        Vector3D normal = record.Normal;
        double scale = _crossing.ScaleOf(block, index, normal);
        double perColumn = Vector3D.Dot(normal, _view.RayPerColumn) * scale;
        double perRow = Vector3D.Dot(normal, _view.RayPerRow) * scale;
        double atFirst = Vector3D.Dot(normal, _view.FirstRay) * scale;
        int number = Band.NotRecorded;
        for (int row = pixels.FirstRow; row <= pixels.LastRow; row++)
        {
            for (int column = pixels.FirstColumn; column <= pixels.LastColumn; column++)
            {
                int start = band.Starts[band.IndexOf(column, row)];
                for (int sample = start; sample < start + (band.VectorsOf(column, row) * Lanes); sample += Lanes)
                {
                    Vector512<double> x = ArrayLanes.Load(band.Columns, sample);
                    Vector512<double> y = ArrayLanes.Load(band.Rows, sample);
                    Vector512<double> inverseDepth = Vector512.Create(atFirst) + (perColumn * x) + (perRow * y);
                    Vector512<double> before = ArrayLanes.Load(band.InverseDepths, sample);
                    Vector512<double> wins = Vector512.LessThanOrEqual(edges.Outside(x, y), Vector512<double>.Zero)
                        & Vector512.GreaterThan(inverseDepth, before);
                    if (wins == Vector512<double>.Zero)
                    {
                        continue;
                    }

                    number = number == Band.NotRecorded ? band.Records.Add(block, index, half) : number;
                    Vector512.ConditionalSelect(wins, inverseDepth, before).StoreTo(band.InverseDepths, sample);
                    CellWinners.Store(Vector256.Create(number), wins, ref ArrayLanes.At(band.Facets, sample));
                }
            }
        }
    }
}
