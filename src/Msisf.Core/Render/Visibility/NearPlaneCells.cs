using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>Draws facets with corners that cannot be projected, because they lie behind the camera or too near to its plane.</summary>
internal sealed class NearPlaneCells
{
    /// <summary>
    /// Fraction of the summed coordinates of an edge's two ends. An edge that meets the camera's plane nearer to the viewing axis than this
    /// leaves the image on both sides, because rounding could turn the sign of the crossing.
    /// </summary>
    private const double MiddleOfPlane = 1e-6;

    private readonly WindowSides _sides = new();
    private ImageView _view = null!;

    /// <summary>Prepares for a frame.</summary>
    public void Begin(ImageView view) => _view = view;

    /// <summary>
    /// Draws the cells of any block one by one, but for those beyond a side of the image; returns the number of cells that were tested.
    /// </summary>
    public long DrawAll<TSamples>(ProjectedBlock block, Band band)
        where TSamples : struct, ISampleKind
    {
        int lines = block.Vertices.Lines - 1;
        uint inBlock = uint.MaxValue >> (CellBlock.Size - (block.Vertices.Samples - 1));
        long tested = 0;
        _sides.Find(block.Vertices, _view, band.Window, band.Margin);
        for (int line = 0; line < lines; line++)
        {
            uint cells = inBlock & block.Vertices.CellsOfLine(line) & _sides.CellsOfLine(line);
            if (cells == 0)
            {
                continue;
            }

            uint halves = block.HalvesOf(line);
            tested += BitOperations.PopCount(cells);
            for (; cells != 0; cells &= cells - 1)
            {
                DrawCell<TSamples>(block, (line * ProjectedBlock.Stride) + BitOperations.TrailingZeroCount(cells), halves, band);
            }
        }

        return tested;
    }

    private void DrawCell<TSamples>(ProjectedBlock block, int index, uint halves, Band band)
        where TSamples : struct, ISampleKind
    {
        if (block.IsUsable(index, _view)
            && block.IsUsable(index + FacetCorners.NorthEast, _view)
            && block.IsUsable(index + FacetCorners.SouthWest, _view)
            && block.IsUsable(index + FacetCorners.SouthEast, _view))
        {
            CellFill.Draw<TSamples>(block, index, halves, band);
            return;
        }

        for (uint left = halves; left != 0; left &= left - 1)
        {
            int half = BitOperations.TrailingZeroCount(left);
            if (TryFind(block, index, half, band.Window, band.Margin, out HomogeneousEdges edges, out PixelRange pixels))
            {
                Fill<TSamples>(block, index, half, edges, pixels, band);
            }
        }
    }

    /// <summary>Finds the edges of a facet and the pixels in which it may lie.</summary>
    /// <param name="index">Index of the north-western vertex of the facet's cell.</param>
    /// <param name="half">0: the south-western facet, 1: the north-eastern one.</param>
    /// <param name="window">The pixels that are drawn.</param>
    /// <param name="margin">px: maximum distance of a sample from its pixel along columns or rows.</param>
    /// <returns>Whether there are such pixels.</returns>
    public bool TryFind(
        ProjectedBlock block, int index, int half, in PixelRange window, double margin, out HomogeneousEdges edges, out PixelRange pixels)
    {
        HomogeneousEdges.Corner a = Corner(block, index);
        HomogeneousEdges.Corner b = Corner(block, index + FacetCorners.Second(half));
        HomogeneousEdges.Corner c = Corner(block, index + FacetCorners.Third(half));
        Extent extent = new(_view);
        Vector3D inImageA = extent.Add(a.FromCamera);
        Vector3D inImageB = extent.Add(b.FromCamera);
        Vector3D inImageC = extent.Add(c.FromCamera);
        extent.AddEdge(inImageA, inImageB);
        extent.AddEdge(inImageB, inImageC);
        extent.AddEdge(inImageC, inImageA);
        pixels = extent.PixelsOf(window, margin);
        if (pixels.IsEmpty)
        {
            edges = default;
            return false;
        }

        edges = new HomogeneousEdges(a, b, c, _view);
        return true;
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void Fill<TSamples>(
        ProjectedBlock block, int index, int half, HomogeneousEdges edges, PixelRange pixels, Band band)
        where TSamples : struct, ISampleKind
    {
        // The inverse depth is linear in the image. It is above 0 at every pixel that passes the test of the edges.
        block.Record(index, half, out FacetRecord record);
        Vector3D normal = record.Normal;
        double scale = ScaleOf(block, index, normal);
        Vector512<double> perColumn = Vector512.Create(Vector3D.Dot(normal, _view.RayPerColumn) * scale);
        Vector512<double> perRow = Vector512.Create(Vector3D.Dot(normal, _view.RayPerRow) * scale);
        Vector512<double> atFirst = Vector512.Create(Vector3D.Dot(normal, _view.FirstRay) * scale);
        Vector512<double> lastColumn = Vector512.Create((double)pixels.LastColumn);
        int number = Band.NotRecorded;
        for (int row = pixels.FirstRow; row <= pixels.LastRow; row++)
        {
            edges.MoveTo(row);
            Vector512<double> atColumn0 = Vector512.Create(Vector3D.Dot(normal, _view.FirstRay + (row * _view.RayPerRow)) * scale);
            Span<double> nearest = band.InverseDepths.AsSpan((row - band.FirstRow) * band.Stride, band.Stride);
            Span<int> facets = band.Facets.AsSpan((row - band.FirstRow) * band.Stride, band.Stride);
            for (int column = pixels.FirstColumn; column <= pixels.LastColumn; column += Vector512<double>.Count)
            {
                Vector512<double> columns = Vector512.Create((double)column) + Vector512.Create(0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0);
                Vector512<double> inverseDepth = atColumn0 + (perColumn * columns);
                Vector512<double> outside;
                if (TSamples.IsPixelCentre)
                {
                    outside = edges.Outside(columns);
                }
                else
                {
                    int sample = band.IndexOf(column, row);
                    Vector512<double> sampleColumns = ArrayLanes.Load(band.SampleColumns, sample);
                    Vector512<double> sampleRows = ArrayLanes.Load(band.SampleRows, sample);
                    outside = edges.Outside(sampleColumns, sampleRows);
                    inverseDepth = atFirst + (perColumn * sampleColumns) + (perRow * sampleRows);
                }

                Vector512<double> before = ArrayLanes.Load(nearest, column);
                Vector512<double> wins = Vector512.LessThanOrEqual(outside, Vector512<double>.Zero)
                    & Vector512.GreaterThan(inverseDepth, before)
                    & Vector512.LessThanOrEqual(columns, lastColumn);
                for (uint bits = (uint)wins.ExtractMostSignificantBits(); bits != 0; bits &= bits - 1)
                {
                    int lane = BitOperations.TrailingZeroCount(bits);
                    number = number == Band.NotRecorded ? band.Records.Add(block, index, half) : number;
                    nearest[column + lane] = inverseDepth[lane];
                    facets[column + lane] = number;
                }
            }
        }
    }

    /// <summary>The dot product of a facet's normal with a ray, times this, is the inverse depth at the ray (1/m).</summary>
    /// <param name="index">Index of the north-western vertex of the facet's cell.</param>
    /// <param name="normal">The facet's normal, of any length.</param>
    public double ScaleOf(ProjectedBlock block, int index, Vector3D normal) =>
        1.0 / (Vector3D.Dot(normal, block.At(index) - _view.Remainder) * _view.Distance);

    private HomogeneousEdges.Corner Corner(ProjectedBlock block, int index) =>
        new(block.At(index) - _view.Remainder, block.X[index], block.Y[index], block.IsUsable(index, _view));

    /// <summary>
    /// The rectangle of the image in which a facet may lie. It follows from the corners in front of the camera and from the points where
    /// edges cross the camera's plane.
    /// </summary>
    private struct Extent(ImageView view)
    {
        private double _left = double.PositiveInfinity;
        private double _right = double.NegativeInfinity;
        private double _top = double.PositiveInfinity;
        private double _bottom = double.NegativeInfinity;

        /// <summary>Adds a corner and returns its dot products with across, down and forward.</summary>
        public Vector3D Add(Vector3D fromCamera)
        {
            Vector3D inImage = new(
                Vector3D.Dot(fromCamera, view.Across), Vector3D.Dot(fromCamera, view.Down), Vector3D.Dot(fromCamera, view.Forward));
            if (inImage.Z > 0.0)
            {
                Widen((inImage.X / inImage.Z) + view.CentreX, ref _left, ref _right);
                Widen((inImage.Y / inImage.Z) + view.CentreY, ref _top, ref _bottom);
            }

            return inImage;
        }

        public void AddEdge(Vector3D a, Vector3D b)
        {
            if (a.Z > 0.0 == b.Z > 0.0)
            {
                return;
            }

            double part = a.Z / (a.Z - b.Z);
            Open(a.X, b.X, part, ref _left, ref _right);
            Open(a.Y, b.Y, part, ref _top, ref _bottom);
        }

        /// <summary>The pixels of the rectangle in a window, with one pixel added on each side for rounding.</summary>
        public readonly PixelRange PixelsOf(in PixelRange window, double sampleMargin)
        {
            double margin = 1.0 + sampleMargin;
            return PixelRange.Within(_left - margin, _right + margin, _top - margin, _bottom + margin, window);
        }

        private static void Widen(double value, ref double min, ref double max)
        {
            min = Math.Min(min, value);
            max = Math.Max(max, value);
        }

        private static void Open(double a, double b, double part, ref double min, ref double max)
        {
            double crossing = a + (part * (b - a));
            double middle = MiddleOfPlane * (Math.Abs(a) + Math.Abs(b));
            min = crossing < middle ? double.NegativeInfinity : min;
            max = crossing > -middle ? double.PositiveInfinity : max;
        }
    }
}
