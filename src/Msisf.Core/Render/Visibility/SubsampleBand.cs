using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera.Lenses;
using Msisf.Core.Camera;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// The depth buffer of the further samples of some rows of an image. The samples of a pixel follow each other in vectors of eight; pixels
/// without further samples take no room. One object is used for many bands.
/// </summary>
internal sealed class SubsampleBand
{
    private byte[] _codes = [];
    private SamplePattern _pattern = SamplePattern.Stratified;

    /// <summary>The image's width, px.</summary>
    public int Width { get; private set; }

    /// <summary>The band's first row in the image, counted from 0.</summary>
    public int FirstRow { get; private set; }

    /// <summary>The band's last row in the image, counted from 0.</summary>
    public int LastRow { get; private set; }

    /// <summary>The pixels that are being drawn: the whole band, or a tile of it.</summary>
    public PixelRange Window { get; private set; }

    /// <summary>px: maximum distance of a sample from its pixel's centre along columns or rows.</summary>
    public double Margin { get; private set; }

    /// <summary>Index of each pixel's first sample; the pixels row by row without gaps. Undefined without samples.</summary>
    public int[] Starts { get; private set; } = [];

    /// <summary>Column of each sample in the plane that is drawn in.</summary>
    public double[] Columns { get; private set; } = [];

    /// <summary>Row of each sample.</summary>
    public double[] Rows { get; private set; } = [];

    /// <summary>Tangent to the right of each sample; only with a lens.</summary>
    public double[] Right { get; private set; } = [];

    /// <summary>Tangent down of each sample; only with a lens.</summary>
    public double[] Down { get; private set; } = [];

    /// <summary>1/m: the inverse depth of each sample's nearest point; 0 where no facet has been drawn.</summary>
    public double[] InverseDepths { get; private set; } = [];

    /// <summary>Index of each sample's facet in <see cref="Records"/>; <see cref="Band.NotRecorded"/> without one.</summary>
    public int[] Facets { get; private set; } = [];

    /// <summary>The facets that have been the nearest one at some sample.</summary>
    public FacetRecords Records { get; } = new();

    /// <summary>Number of samples.</summary>
    public int Count { get; private set; }

    /// <summary>Empties the band for new rows of an image, and places the samples of a pinhole.</summary>
    /// <param name="pixels">The pixels that get samples.</param>
    public void Begin(SampledPixels pixels, CameraModel model, SampledBand band)
    {
        Width = model.Width;
        (FirstRow, LastRow) = (band.FirstRow, band.LastRow);
        Window = new PixelRange(0, Width - 1, FirstRow, LastRow);
        _pattern = pixels.Pattern;
        Margin = _pattern.Reach;
        Records.Clear();
        Count = band.Vectors * SamplePattern.Lanes;
        _codes = pixels.Codes;
        EnsureRoom(model.Lens is not null);
        InverseDepths.AsSpan(0, Count).Clear();
        Facets.AsSpan(0, Count).Fill(Band.NotRecorded);
        int next = 0;
        for (int pixel = NextPixel(0); pixel >= 0; pixel = NextPixel(pixel + 1))
        {
            (int row, int column) = Math.DivRem(pixel, Width);
            int vectors = VectorsOf(column, FirstRow + row);
            int end = next + (vectors * SamplePattern.Lanes);
            Starts[pixel] = next;

            // In front of what fills up the last vector no facet is ever seen.
            InverseDepths.AsSpan((next + _pattern.SamplesIn(vectors))..end).Fill(double.PositiveInfinity);
            if (model.Lens is null)
            {
                Place(column, FirstRow + row, next, end);
            }

            next = end;
        }
    }

    /// <summary>The next pixel with samples, counted from the band's first pixel on; -1 if there is none.</summary>
    public int NextPixel(int pixel)
    {
        int first = FirstRow * Width;
        int next = _codes.AsSpan(first + pixel, ((LastRow - FirstRow + 1) * Width) - pixel).IndexOfAnyExcept((byte)0);
        return next < 0 ? -1 : pixel + next;
    }

    /// <summary>Number of vectors of samples of a pixel.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int VectorsOf(int column, int row) => _codes[(row * Width) + column] & SampledPixels.Vectors;

    /// <summary>Number of samples of a pixel with some vectors.</summary>
    public int SamplesIn(int vectors) => _pattern.SamplesIn(vectors);

    /// <summary>Whether each sample of a pixel gets light of its own.</summary>
    public bool HasBorder(int column, int row) => (_codes[(row * Width) + column] & SampledPixels.HasBorder) != 0;

    /// <summary>Index of a pixel in <see cref="Starts"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int IndexOf(int column, int row) => ((row - FirstRow) * Width) + column;

    /// <summary>Whether a pixel of a rectangle has samples.</summary>
    public bool HasSamples(in PixelRange pixels)
    {
        for (int row = pixels.FirstRow; row <= pixels.LastRow; row++)
        {
            if (_codes.AsSpan((row * Width) + pixels.FirstColumn, pixels.LastColumn - pixels.FirstColumn + 1)
                .IndexOfAnyExcept((byte)0) >= 0)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Finds where a lens puts the samples in the ideal image plane.</summary>
    /// <param name="known">All samples of the image, with this pattern in every pixel; null to compute those that are needed.</param>
    /// <returns>The part of the plane in which they lie.</returns>
    public TangentBox PlaceInLens(CameraModel model, LensSamples? known)
    {
        (LaneRange acrossRange, LaneRange alongRange) = (LaneRange.Nothing, LaneRange.Nothing);
        for (int row = FirstRow; row <= LastRow; row++)
        {
            for (int column = 0; column < Width; column++)
            {
                int start = Starts[IndexOf(column, row)];
                int samples = VectorsOf(column, row) * SamplePattern.Lanes;
                if (known is not null)
                {
                    Copy(known, ((row * Width) + column) * _pattern.Count, start, samples);
                }

                for (int sample = 0; sample < samples; sample += SamplePattern.Lanes)
                {
                    if (known is null)
                    {
                        LanePoints ideal = model.ToIdeal(
                            ArrayLanes.Load(_pattern.Right, sample) + Vector512.Create(column + 1.0),
                            ArrayLanes.Load(_pattern.Down, sample) + Vector512.Create(row + 1.0));
                        ideal.X.StoreTo(Right, start + sample);
                        ideal.Y.StoreTo(Down, start + sample);
                    }

                    acrossRange.Widen(ArrayLanes.Load(Right, start + sample));
                    alongRange.Widen(ArrayLanes.Load(Down, start + sample));
                }
            }
        }

        return new TangentBox(acrossRange.Min, alongRange.Min, acrossRange.Max, alongRange.Max);
    }

    /// <summary>Copies the samples of a pixel; what fills up the last vector lies where the last one does.</summary>
    private void Copy(LensSamples known, int first, int start, int samples)
    {
        int count = _pattern.Count;
        known.Right.AsSpan(first, count).CopyTo(Right.AsSpan(start));
        known.Down.AsSpan(first, count).CopyTo(Down.AsSpan(start));
        Right.AsSpan((start + count)..(start + samples)).Fill(Right[start + count - 1]);
        Down.AsSpan((start + count)..(start + samples)).Fill(Down[start + count - 1]);
    }

    /// <summary>Places the samples of a tile of an image with a lens in the plane of the tile.</summary>
    /// <returns>
    /// The tile as far as it lies in the band, with the margin and the tangents of its samples; without pixels if it lies outside.
    /// </returns>
    public LensTile Place(LensTile tile)
    {
        PixelRange window = tile.Pixels with
        {
            FirstRow = Math.Max(FirstRow, tile.Pixels.FirstRow),
            LastRow = Math.Min(LastRow, tile.Pixels.LastRow),
        };
        double margin = 0.0;
        TangentBox box = TangentBox.Nothing;
        for (int row = window.FirstRow; row <= window.LastRow; row++)
        {
            for (int column = window.FirstColumn; column <= window.LastColumn; column++)
            {
                int start = Starts[IndexOf(column, row)];
                int end = start + (VectorsOf(column, row) * SamplePattern.Lanes);
                for (int sample = start; sample < end; sample++)
                {
                    double x = tile.Map.Column(Right[sample], Down[sample]);
                    double y = tile.Map.Row(Right[sample], Down[sample]);
                    (Columns[sample], Rows[sample]) = (x, y);
                    margin = Math.Max(margin, Math.Max(Math.Abs(x - column), Math.Abs(y - row)));
                    box = box.With(Right[sample], Down[sample]);
                }
            }
        }

        return new LensTile(window, tile.Map, margin, box);
    }

    /// <summary>Goes on with one tile of an image with a lens.</summary>
    public void Narrow(LensTile tile)
    {
        Window = tile.Pixels;
        Margin = tile.Margin;
    }

    private void Place(int column, int row, int start, int end)
    {
        for (int sample = start; sample < end; sample += SamplePattern.Lanes)
        {
            (ArrayLanes.Load(_pattern.Right, sample - start) + Vector512.Create((double)column))
                .StoreTo(Columns, sample);
            (ArrayLanes.Load(_pattern.Down, sample - start) + Vector512.Create((double)row)).StoreTo(Rows, sample);
        }
    }

    private void EnsureRoom(bool hasLens)
    {
        int pixels = Width * (LastRow - FirstRow + 1);
        if (Starts.Length < pixels)
        {
            Starts = new int[pixels];
        }

        if (InverseDepths.Length < Count)
        {
            int room = Count + (Count / 4);
            InverseDepths = new double[room];
            Facets = new int[room];
            Columns = new double[room];
            Rows = new double[room];
        }

        if (hasLens && Right.Length < InverseDepths.Length)
        {
            Right = new double[InverseDepths.Length];
            Down = new double[InverseDepths.Length];
        }
    }
}

/// <summary>Rows of an image whose further samples are drawn together.</summary>
/// <param name="FirstRow">The first row, counted from 0.</param>
/// <param name="Vectors">Number of vectors of <see cref="SamplePattern.Lanes"/> samples in them.</param>
internal readonly record struct SampledBand(int FirstRow, int LastRow, int Vectors);
