using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Camera.Lenses;
using Msisf.Core.Parallel;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Where the ideal image plane is sampled by the pixels of a camera with a lens: the points of each pixel, and the tiles in which pixels
/// are drawn. One object serves many frames, several at a time.
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
    private SamplePattern _pattern = SamplePattern.Centre;
    private TangentBox[] _bands = [];
    private IReadOnlyList<LensTile>?[] _tiles = [];

    /// <summary>Tangent to the right of each sample, row by row, those of a pixel beside each other.</summary>
    public double[] Right { get; private set; } = [];

    /// <summary>Tangent down of each sample.</summary>
    public double[] Down { get; private set; } = [];

    /// <summary>The part of the ideal image plane in which all samples lie.</summary>
    public TangentBox Tangents { get; private set; }

    /// <summary>Whether these are the samples of a camera with a pattern.</summary>
    public bool IsOf(CameraModel model, SamplePattern pattern) => IsOf(model) && _pattern.Equals(pattern);

    /// <summary>Whether these are samples of a camera.</summary>
    public bool IsOf(CameraModel model) => ReferenceEquals(_model, model);

    /// <summary>Computes the samples of a camera.</summary>
    /// <param name="model">The camera, with a lens.</param>
    /// <param name="pattern">Where the samples of a pixel lie.</param>
    public void Prepare(CameraModel model, SamplePattern pattern, int threads, CancellationToken cancellation)
    {
        _model = null;
        _pattern = pattern;
        int size = model.Width * model.Height * pattern.Count;
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
        int inRow = model.Width * _pattern.Count;
        int last = ((pixels.LastRow + 1) * inRow) - 1;
        for (int sample = pixels.FirstRow * inRow; sample <= last; sample += Vector512<double>.Count)
        {
            right.Widen(Read(Right, sample, last));
            down.Widen(Read(Down, sample, last));
        }

        return new TangentBox(right.Min, down.Min, right.Max, down.Max);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void FillRow(CameraModel model, int row)
    {
        int count = _pattern.Count;
        Span<double> right = Right.AsSpan(row * model.Width * count, model.Width * count);
        Span<double> down = Down.AsSpan(row * model.Width * count, model.Width * count);
        Span<double> columns = stackalloc double[Vector512<double>.Count];
        for (int column = 0; column < model.Width; column += columns.Length)
        {
            for (int lane = 0; lane < columns.Length; lane++)
            {
                columns[lane] = Math.Min(column + lane, model.Width - 1) + 1;
            }

            Vector512<double> middles = Vector512.Create<double>(columns);
            for (int sample = 0; sample < count; sample++)
            {
                LanePoints ideal = model.ToIdeal(
                    middles + Vector512.Create(_pattern.Right[sample]), Vector512.Create(row + 1.0 + _pattern.Down[sample]));
                for (int lane = 0; lane < columns.Length && column + lane < model.Width; lane++)
                {
                    int place = ((column + lane) * count) + sample;
                    (right[place], down[place]) = (ideal.X[lane], ideal.Y[lane]);
                }
            }
        }
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
