using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Camera.Lenses;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Where the ideal image plane is sampled by the pixels of a camera with a lens: a point for each pixel, and the tiles in which they are
/// drawn. One object serves many frames; see <see cref="IsOf"/>.
/// </summary>
internal sealed class LensSamples
{
    /// <summary>
    /// Parts of a cell: tiles are halved until no sample is farther from its pixel. Measured: with less the tiles are smaller and each
    /// block
    /// is projected more often; with more each cell is tested against more samples.
    /// </summary>
    private const double MarginPerCell = 0.15;

    /// <summary>px: the smallest margin for which tiles are made; each further kind of tiles has twice the margin.</summary>
    private const double MinMargin = 0.1;

    /// <summary>Kinds of tiles.</summary>
    private const int Kinds = 8;

    /// <summary>px: tiles are not halved below this side.</summary>
    private const int MinSide = 8;

    /// <summary>px: more than the rounding of a sample's column or row.</summary>
    private const double Rounding = 1e-9;

    private CameraModel? _model;
    private TangentBox[] _bands = [];
    private IReadOnlyList<LensTile>?[] _tiles = [];
    private (double X, double Y) _offset;

    /// <summary>Tangent to the right of each pixel's sample, row by row.</summary>
    public double[] Right { get; private set; } = [];

    /// <summary>Tangent down of each pixel's sample, row by row.</summary>
    public double[] Down { get; private set; } = [];

    /// <summary>The part of the ideal image plane in which all samples lie.</summary>
    public TangentBox Tangents { get; private set; }

    /// <summary>Whether these are the samples of a camera at these offsets.</summary>
    public bool IsOf(CameraModel model, double offsetX, double offsetY) =>
        ReferenceEquals(_model, model) && _offset == (offsetX, offsetY);

    /// <summary>Computes the samples of a camera.</summary>
    /// <param name="model">The camera, with a lens.</param>
    /// <param name="offsetX">px to the right, added to each pixel's centre.</param>
    /// <param name="offsetY">px down.</param>
    /// <param name="threads">Maximum number of threads.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void Prepare(CameraModel model, double offsetX, double offsetY, int threads, CancellationToken cancellation)
    {
        _model = null;
        int size = model.Width * model.Height;
        if (Right.Length < size)
        {
            Right = new double[size];
            Down = new double[size];
        }

        TangentBox[] bands = new TangentBox[(model.Height + VisibleSurface.BandRows - 1) / VisibleSurface.BandRows];
        WorkerTeam.Run(threads, bands.Length, (_, band) =>
        {
            PixelRange pixels = PixelsOf(model, band);
            for (int row = pixels.FirstRow; row <= pixels.LastRow; row++)
            {
                FillRow(model, row, offsetX, offsetY);
            }

            bands[band] = TangentsOf(model, pixels);
        }, cancellation);

        _bands = bands;
        _tiles = new IReadOnlyList<LensTile>?[bands.Length * Kinds];
        Tangents = bands.Aggregate(TangentBox.Nothing, (all, band) => all.With(band));
        (_model, _offset) = (model, (offsetX, offsetY));
    }

    /// <summary>The part of the ideal image plane in which the samples of a band lie.</summary>
    public TangentBox TangentsOf(int band) => _bands[band];

    /// <summary>The tiles of a band; they are made when they are first needed, by the thread that draws the band.</summary>
    /// <param name="band">Index of the band.</param>
    /// <param name="cellPixels">px: about the width of the cells that are drawn.</param>
    public IReadOnlyList<LensTile> TilesOf(int band, double cellPixels)
    {
        double kinds = Math.Floor(Math.Log2(Math.Max(MinMargin, MarginPerCell * cellPixels) / MinMargin));
        int kind = kinds < Kinds ? (int)kinds : Kinds - 1; // also for cells of no known width
        ref IReadOnlyList<LensTile>? tiles = ref _tiles[(band * Kinds) + kind];
        if (tiles is null)
        {
            List<LensTile> found = [];
            Divide(_model!, PixelsOf(_model!, band), Math.ScaleB(MinMargin, kind), found);
            tiles = found;
        }

        return tiles;
    }

    private static PixelRange PixelsOf(CameraModel model, int band)
    {
        int first = band * VisibleSurface.BandRows;
        return new PixelRange(0, model.Width - 1, first, Math.Min(model.Height, first + VisibleSurface.BandRows) - 1);
    }

    private TangentBox TangentsOf(CameraModel model, PixelRange pixels)
    {
        Range right = Range.Nothing;
        Range down = Range.Nothing;
        int last = ((pixels.LastRow + 1) * model.Width) - 1;
        for (int sample = pixels.FirstRow * model.Width; sample <= last; sample += Vector512<double>.Count)
        {
            right.Widen(Read(Right, sample, last));
            down.Widen(Read(Down, sample, last));
        }

        return new TangentBox(right.Min, down.Min, right.Max, down.Max);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void FillRow(CameraModel model, int row, double offsetX, double offsetY)
    {
        Span<double> right = Right.AsSpan(row * model.Width, model.Width);
        Span<double> down = Down.AsSpan(row * model.Width, model.Width);
        Span<double> columns = stackalloc double[Vector512<double>.Count];
        for (int column = 0; column < model.Width; column += columns.Length)
        {
            for (int lane = 0; lane < columns.Length; lane++)
            {
                columns[lane] = Math.Min(column + lane, model.Width - 1) + 1 + offsetX;
            }

            LanePoints ideal = model.ToIdeal(Vector512.Create<double>(columns), Vector512.Create(row + 1 + offsetY));
            for (int lane = 0; lane < columns.Length && column + lane < model.Width; lane++)
            {
                (right[column + lane], down[column + lane]) = (ideal.X[lane], ideal.Y[lane]);
            }
        }
    }

    /// <summary>Halves a rectangle until a linear map fits.</summary>
    private void Divide(CameraModel model, PixelRange pixels, double maxMargin, List<LensTile> tiles)
    {
        LensTile tile = TileOf(model, pixels);
        (int width, int height) = (pixels.LastColumn - pixels.FirstColumn + 1, pixels.LastRow - pixels.FirstRow + 1);
        if (tile.Margin <= maxMargin || Math.Max(width, height) <= MinSide)
        {
            tiles.Add(tile);
            return;
        }

        if (width >= height)
        {
            int middle = pixels.FirstColumn + (width / 2);
            Divide(model, pixels with { LastColumn = middle - 1 }, maxMargin, tiles);
            Divide(model, pixels with { FirstColumn = middle }, maxMargin, tiles);
        }
        else
        {
            int middle = pixels.FirstRow + (height / 2);
            Divide(model, pixels with { LastRow = middle - 1 }, maxMargin, tiles);
            Divide(model, pixels with { FirstRow = middle }, maxMargin, tiles);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private LensTile TileOf(CameraModel model, PixelRange pixels)
    {
        ImagePlaneMap map = MapOf(model, pixels, _offset.X, _offset.Y);
        Range across = Range.Nothing;
        Range down = Range.Nothing;
        Range right = Range.Nothing;
        Range below = Range.Nothing;
        for (int row = pixels.FirstRow; row <= pixels.LastRow; row++)
        {
            int start = row * model.Width;
            for (int column = pixels.FirstColumn; column <= pixels.LastColumn; column += Vector512<double>.Count)
            {
                // The last vector goes back over pixels that were met already, or repeats the last one.
                int first = Math.Max(pixels.FirstColumn, Math.Min(column, pixels.LastColumn + 1 - Vector512<double>.Count));
                Vector512<double> columns = Vector512.Min(
                    Vector512.Create((double)first) + Vector512.Create(0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0),
                    Vector512.Create((double)pixels.LastColumn));
                Vector512<double> x = Read(Right, start + first, start + pixels.LastColumn);
                Vector512<double> y = Read(Down, start + first, start + pixels.LastColumn);
                across.Widen((map.ColumnPerRight * x) + (map.ColumnPerDown * y) + Vector512.Create(map.Column0) - columns);
                down.Widen((map.RowPerRight * x) + (map.RowPerDown * y) + Vector512.Create(map.Row0 - row));
                right.Widen(x);
                below.Widen(y);
            }
        }

        map = map with { Column0 = map.Column0 - across.Middle, Row0 = map.Row0 - down.Middle };
        return new LensTile(
            pixels, map, (0.5 * Math.Max(across.Width, down.Width)) + Rounding,
            new TangentBox(right.Min, below.Min, right.Max, below.Max));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Read(double[] values, int first, int last)
    {
        if (last - first >= Vector512<double>.Count - 1)
        {
            return Vector512.LoadUnsafe(ref values[first]);
        }

        Vector512<double> read = Vector512.Create(values[last]);
        for (int lane = 0; first + lane < last; lane++)
        {
            read = read.WithElement(lane, values[first + lane]);
        }

        return read;
    }

    /// <summary>The linear map that follows the lens from one side of a rectangle to the other.</summary>
    private static ImagePlaneMap MapOf(CameraModel model, PixelRange pixels, double offsetX, double offsetY)
    {
        double x = (0.5 * (pixels.FirstColumn + pixels.LastColumn)) + 1.0 + offsetX;
        double y = (0.5 * (pixels.FirstRow + pixels.LastRow)) + 1.0 + offsetY;

        // The chord over 0.7 of the side leaves the smallest greatest distance from a cubic.
        double across = Math.Max(0.5, 0.35 * (pixels.LastColumn - pixels.FirstColumn));
        double down = Math.Max(0.5, 0.35 * (pixels.LastRow - pixels.FirstRow));
        (double rightOfLeft, double downOfLeft) = model.ToIdeal(x - across, y);
        (double rightOfRight, double downOfRight) = model.ToIdeal(x + across, y);
        (double rightOfTop, double downOfTop) = model.ToIdeal(x, y - down);
        (double rightOfBottom, double downOfBottom) = model.ToIdeal(x, y + down);
        double a = (rightOfRight - rightOfLeft) / (2.0 * across);
        double b = (rightOfBottom - rightOfTop) / (2.0 * down);
        double c = (downOfRight - downOfLeft) / (2.0 * across);
        double d = (downOfBottom - downOfTop) / (2.0 * down);
        double determinant = (a * d) - (b * c);
        (double middleRight, double middleDown) = model.ToIdeal(x, y);
        ImagePlaneMap map = new(d / determinant, -b / determinant, 0.0, -c / determinant, a / determinant, 0.0);
        return map with
        {
            Column0 = x - 1.0 - offsetX - map.Column(middleRight, middleDown),
            Row0 = y - 1.0 - offsetY - map.Row(middleRight, middleDown),
        };
    }

    /// <summary>The limits of many numbers.</summary>
    private struct Range
    {
        private Vector512<double> _min;
        private Vector512<double> _max;

        public static Range Nothing => new()
        {
            _min = Vector512.Create(double.PositiveInfinity),
            _max = Vector512.Create(double.NegativeInfinity),
        };

        public readonly double Min
        {
            get
            {
                double min = _min[0];
                for (int lane = 1; lane < Vector512<double>.Count; lane++)
                {
                    min = Math.Min(min, _min[lane]);
                }

                return min;
            }
        }

        public readonly double Max
        {
            get
            {
                double max = _max[0];
                for (int lane = 1; lane < Vector512<double>.Count; lane++)
                {
                    max = Math.Max(max, _max[lane]);
                }

                return max;
            }
        }

        public readonly double Middle => 0.5 * (Min + Max);

        public readonly double Width => Max - Min;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Widen(Vector512<double> by)
        {
            _min = Vector512.MinNative(_min, by);
            _max = Vector512.MaxNative(_max, by);
        }
    }
}
