using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Camera.Lenses;
using Msisf.Core.Parallel;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Where the ideal image plane is sampled by the pixels of a camera with a lens: the point of each pixel's centre, and the tiles in which
/// pixels are drawn. One object serves many frames, several at a time.
/// </summary>
internal sealed class LensSamples
{
    /// <summary>
    /// Parts of a cell: tiles are halved until no sample is farther from its pixel. Measured: with less the tiles are smaller and each
    /// block is projected more often; with more each cell is tested against more samples.
    /// </summary>
    private const double MarginPerCell = 0.15;

    /// <summary>px: the smallest margin for which tiles are made; each further kind of tiles has twice the margin.</summary>
    private const double MinMargin = 0.1;

    /// <summary>Kinds of tiles.</summary>
    private const int Kinds = 8;

    private CameraModel? _model;
    private TangentBox[] _bands = [];
    private IReadOnlyList<LensTile>?[] _tiles = [];

    /// <summary>Tangent to the right of each pixel's centre, row by row.</summary>
    public double[] Right { get; private set; } = [];

    /// <summary>Tangent down of each pixel's centre.</summary>
    public double[] Down { get; private set; } = [];

    /// <summary>The part of the ideal image plane in which all samples lie.</summary>
    public TangentBox Tangents { get; private set; }

    /// <summary>Whether these are samples of a camera.</summary>
    public bool IsOf(CameraModel model) => ReferenceEquals(_model, model);

    /// <summary>Computes the samples of a camera.</summary>
    /// <param name="model">The camera, with a lens.</param>
    public void Prepare(CameraModel model, int threads, CancellationToken cancellation)
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
                FillRow(model, row);
            }

            bands[band] = TangentsOf(model, pixels);
        }, cancellation);

        _bands = bands;
        _tiles = new IReadOnlyList<LensTile>?[bands.Length * Kinds];
        Tangents = bands.Aggregate(TangentBox.Nothing, (all, band) => all.With(band));
        _model = model;
    }

    /// <summary>The part of the ideal image plane in which the samples of a band lie.</summary>
    public TangentBox TangentsOf(int band) => _bands[band];

    /// <summary>The tiles of a band; they are made when they are first needed, by the thread that draws the band. If two
    /// frames need them at once, both make the same ones.</summary>
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
            new LensTiling(_model!, this).Divide(PixelsOf(_model!, band), Math.ScaleB(MinMargin, kind), found);
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
        LaneRange right = LaneRange.Nothing;
        LaneRange down = LaneRange.Nothing;
        int last = ((pixels.LastRow + 1) * model.Width) - 1;
        for (int sample = pixels.FirstRow * model.Width; sample <= last; sample += Vector512<double>.Count)
        {
            right.Widen(Read(Right, sample, last));
            down.Widen(Read(Down, sample, last));
        }

        return new TangentBox(right.Min, down.Min, right.Max, down.Max);
    }

    private void FillRow(CameraModel model, int row)
    {
        Span<double> right = Right.AsSpan(row * model.Width, model.Width);
        Span<double> down = Down.AsSpan(row * model.Width, model.Width);
        for (int column = 0; column < model.Width; column += Vector512<double>.Count)
        {
            LanePoints ideal = EightPixels(model, column, row, right: 0.0, down: 0.0);
            for (int lane = 0; lane < Vector512<double>.Count && column + lane < model.Width; lane++)
            {
                (right[column + lane], down[column + lane]) = (ideal.X[lane], ideal.Y[lane]);
            }
        }
    }

    /// <summary>The ideal points of one sample of eight pixels of a row; behind the last pixel its own.</summary>
    /// <param name="right">px: distance of the sample from the pixels' centres.</param>
    /// <param name="down">As <paramref name="right"/>.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static LanePoints EightPixels(CameraModel model, int column, int row, double right, double down)
    {
        Vector512<double> centres = Vector512.Min(
            Vector512.Create(column + 1.0) + Vector512.Create(0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0),
            Vector512.Create((double)model.Width));
        return model.ToIdeal(centres + Vector512.Create(right), Vector512.Create(row + 1.0 + down));
    }

    /// <summary>Reads eight numbers; beyond the last one it is repeated.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<double> Read(double[] values, int first, int last)
    {
        if (last - first >= Vector512<double>.Count - 1)
        {
            return ArrayLanes.Load(values, first);
        }

        Vector512<double> read = Vector512.Create(values[last]);
        for (int lane = 0; first + lane < last; lane++)
        {
            read = read.WithElement(lane, values[first + lane]);
        }

        return read;
    }
}
