using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Draws a block's cells into the further samples of a band. Pixels whose samples all lie in one facet are found first. In the others a
/// cell is tested against four samples at a time, with the edge functions of <see cref="CellRasterizer"/>; cells whose box holds no pixel
/// with samples are dropped.
/// </summary>
internal sealed class SubsampleCells
{
    private const int Lanes = 8;

    /// <summary>px: in cells that are wider, the columns of each row are found from the cell's sides.</summary>
    private const int WideCell = 4;

    /// <summary>px: in cells that are smaller, no pixel is looked for whose samples all lie in one facet.</summary>
    private const int LeastInner = 2;

    private static readonly (double First, double Last) None = (double.PositiveInfinity, double.NegativeInfinity);

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
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be drawn with unoptimised vectors
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
        bool hasInner = pixels.LastColumn - pixels.FirstColumn >= LeastInner && pixels.LastRow - pixels.FirstRow >= LeastInner;
        InnerPixels innerSouthWest = hasInner ? new InnerPixels(northWest, southWest, southEast, band.Margin) : default;
        InnerPixels innerNorthEast = hasInner ? new InnerPixels(northWest, southEast, northEast, band.Margin) : default;
        CellWinners winners = new();
        int southWestFacet = Band.NotRecorded;
        int northEastFacet = Band.NotRecorded;
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

            (double First, double Last) ofSouthWest = None;
            (double First, double Last) ofNorthEast = None;
            if (hasInner)
            {
                ofSouthWest = (halves & FacetCorners.SouthWestHalf) != 0 ? innerSouthWest.At(row) : None;
                ofNorthEast = (halves & FacetCorners.NorthEastHalf) != 0 ? innerNorthEast.At(row) : None;
            }

            for (int column = begin; column <= end; column++)
            {
                if (band.VectorsOf(column, row) == 0)
                {
                    continue;
                }

                int pixel = band.IndexOf(column, row);
                bool isInSouthWest = column >= ofSouthWest.First && column <= ofSouthWest.Last;
                bool isInNorthEast = column >= ofNorthEast.First && column <= ofNorthEast.Last;
                if (isInSouthWest)
                {
                    if (southWestFacet == Band.NotRecorded)
                    {
                        southWestFacet = winners.NumberOf(band.Records, block, index, half: 0);
                        band.SetPlane(southWestFacet, FacetPlane.Of(northWest, southWest, southEast));
                    }

                    if (band.TryDrawWhole(column, row, pixel, southWestFacet))
                    {
                        continue;
                    }
                }
                else if (isInNorthEast)
                {
                    if (northEastFacet == Band.NotRecorded)
                    {
                        northEastFacet = winners.NumberOf(band.Records, block, index, half: 1);
                        band.SetPlane(northEastFacet, FacetPlane.Of(northWest, southEast, northEast));
                    }

                    if (band.TryDrawWhole(column, row, pixel, northEastFacet))
                    {
                        continue;
                    }
                }

                DrawSamples(block, index, halves, column, row, pixel, band, ref winners);
            }
        }
    }

    /// <summary>Draws a cell in the samples of a pixel, four at a time.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void DrawSamples(
        ProjectedBlock block, int index, uint halves, int column, int row, int pixel, SubsampleBand band, ref CellWinners winners)
    {
        CellCorner northWest = new(block, index);
        CellCorner northEast = new(block, index + FacetCorners.NorthEast);
        CellCorner southWest = new(block, index + FacetCorners.SouthWest);
        CellCorner southEast = new(block, index + FacetCorners.SouthEast);
        Vector256<double> southWestMask = Vector256.Create((halves & FacetCorners.SouthWestHalf) != 0 ? -1L : 0L).AsDouble();
        Vector256<double> northEastMask = Vector256.Create((halves & FacetCorners.NorthEastHalf) != 0 ? -1L : 0L).AsDouble();
        int count = band.SamplesIn(band.VectorsOf(column, row));
        for (int first = 0; first < count; first += Vector256<double>.Count)
        {
            band.ReadPlaces(column, row, pixel, first, out Vector256<double> x, out Vector256<double> y);
            FourCellEdges edges = new(
                Vector256.Create(northWest.X) - x,
                Vector256.Create(northWest.Y) - y,
                Vector256.Create(northEast.X) - x,
                Vector256.Create(northEast.Y) - y,
                Vector256.Create(southWest.X) - x,
                Vector256.Create(southWest.Y) - y,
                Vector256.Create(southEast.X) - x,
                Vector256.Create(southEast.Y) - y);
            Vector256<double> inSouthWest = southWestMask & Vector256.LessThanOrEqual(edges.MaxOfSouthWest, Vector256<double>.Zero);
            Vector256<double> inNorthEast = northEastMask & Vector256.LessThanOrEqual(edges.MaxOfNorthEast, Vector256<double>.Zero);
            if ((inSouthWest | inNorthEast) == Vector256<double>.Zero)
            {
                continue;
            }

            // As in CellRasterizer: a sample in both facets is on the diagonal, where both have the same depth.
            Vector256<double> ofNorthWest = Vector256.ConditionalSelect(inSouthWest, edges.South, edges.East);
            Vector256<double> ofSouthEast = Vector256.ConditionalSelect(inSouthWest, edges.West, edges.North);
            Vector256<double> ofThird = Vector256.ConditionalSelect(inSouthWest, -edges.Diagonal, edges.Diagonal);
            Vector256<double> atThird = Vector256.ConditionalSelect(
                inSouthWest, Vector256.Create(southWest.InverseDepth), Vector256.Create(northEast.InverseDepth));
            Vector256<double> inverseDepth = ((ofNorthWest * northWest.InverseDepth) + (ofSouthEast * southEast.InverseDepth)
                + (ofThird * atThird)) / (ofNorthWest + ofSouthEast + ofThird);
            band.Part(column, row, pixel);
            int sample = band.Starts[pixel] + first;
            Vector256<double> before = ArrayLanes.Load256(band.InverseDepths, sample);
            Vector256<double> wins = (inSouthWest | inNorthEast) & Vector256.GreaterThan(inverseDepth, before);
            if (wins == Vector256<double>.Zero)
            {
                continue;
            }

            Vector256.ConditionalSelect(wins, inverseDepth, before).StoreTo(band.InverseDepths, sample);
            winners.Store(band.Records, block, index, wins, inSouthWest, ref ArrayLanes.At(band.Facets, sample));
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
                int pixel = band.IndexOf(column, row);
                int count = band.VectorsOf(column, row) * Lanes;
                for (int first = 0; first < count; first += Lanes)
                {
                    band.ReadPlaces(column, row, pixel, first, out Vector512<double> x, out Vector512<double> y);
                    Vector512<double> inverseDepth = Vector512.Create(atFirst) + (perColumn * x) + (perRow * y);
                    Vector512<double> isInside = Vector512.LessThanOrEqual(edges.Outside(x, y), Vector512<double>.Zero);
                    if (isInside == Vector512<double>.Zero)
                    {
                        continue;
                    }

                    band.Part(column, row, pixel);
                    int sample = band.Starts[pixel] + first;
                    Vector512<double> before = ArrayLanes.Load(band.InverseDepths, sample);
                    Vector512<double> wins = isInside & Vector512.GreaterThan(inverseDepth, before);
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
