using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera.Lenses;
using Msisf.Core.Camera;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// The depth buffer of the further samples of some rows of an image. The samples of a pixel follow each other in vectors of eight; pixels
/// without further samples take no room. As long as all samples of a pixel see the same facet, the pixel only has the facet's number. One
/// object is used for many bands.
/// </summary>
internal sealed class SubsampleBand
{
    /// <summary>State of a pixel in which no facet has been drawn.</summary>
    private const int Untouched = -1;

    /// <summary>
    /// State of a pixel whose samples have their own depths; other states are the number of the facet that all of them see.
    /// </summary>
    private const int Apart = -2;

    private byte[] _codes = [];
    private int[] _states = [];
    private FacetPlane[] _planes = [];
    private bool _hasLens;

    /// <summary>The image's width, px.</summary>
    public int Width { get; private set; }

    /// <summary>The band's first row in the image, counted from 0.</summary>
    public int FirstRow { get; private set; }

    /// <summary>The band's last row in the image, counted from 0.</summary>
    public int LastRow { get; private set; }

    /// <summary>The pixels that are being drawn: the whole band, or a tile of it.</summary>
    public PixelRange Window { get; private set; }

    /// <summary>Where the samples of a pixel lie.</summary>
    public SamplePattern Pattern { get; private set; } = SamplePattern.Stratified;

    /// <summary>px: maximum distance of a sample from its pixel's centre along columns or rows.</summary>
    public double Margin { get; private set; }

    /// <summary>Index of each pixel's first sample; the pixels row by row without gaps. Undefined without samples.</summary>
    public int[] Starts { get; private set; } = [];

    /// <summary>Column of each sample in the plane that is drawn in; only with a lens.</summary>
    public double[] Columns { get; private set; } = [];

    /// <summary>Row of each sample; only with a lens.</summary>
    public double[] Rows { get; private set; } = [];

    /// <summary>Tangent to the right of each sample; only with a lens.</summary>
    public double[] Right { get; private set; } = [];

    /// <summary>Tangent down of each sample; only with a lens.</summary>
    public double[] Down { get; private set; } = [];

    /// <summary>
    /// 1/m: the inverse depth of each sample's nearest point; 0 where no facet has been drawn. Undefined before <see cref="Part"/>.
    /// </summary>
    public double[] InverseDepths { get; private set; } = [];

    /// <summary>
    /// Index of each sample's facet in <see cref="Records"/>; <see cref="Band.NotRecorded"/> without one. Undefined before
    /// <see cref="Part"/>.
    /// </summary>
    public int[] Facets { get; private set; } = [];

    /// <summary>The facets that have been the nearest one at some sample.</summary>
    public FacetRecords Records { get; } = new();

    /// <summary>Number of samples.</summary>
    public int Count { get; private set; }

    /// <summary>Empties the band for new rows of an image.</summary>
    /// <param name="pixels">The pixels that get samples.</param>
    public void Begin(SampledPixels pixels, CameraModel model, SampledBand band)
    {
        Width = model.Width;
        (FirstRow, LastRow) = (band.FirstRow, band.LastRow);
        Window = new PixelRange(0, Width - 1, FirstRow, LastRow);
        Pattern = pixels.Pattern;
        Margin = Pattern.Reach;
        Records.Clear();
        Count = band.Vectors * SamplePattern.Lanes;
        _codes = pixels.Codes;
        _hasLens = model.Lens is not null;
        EnsureRoom();
        _states.AsSpan(0, Width * (LastRow - FirstRow + 1)).Fill(Untouched);
        int next = 0;
        for (int pixel = NextPixel(0); pixel >= 0; pixel = NextPixel(pixel + 1))
        {
            Starts[pixel] = next;
            next += (_codes[(FirstRow * Width) + pixel] & SampledPixels.Vectors) * SamplePattern.Lanes;
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
    public int SamplesIn(int vectors) => Pattern.SamplesIn(vectors);

    /// <summary>Whether each sample of a pixel gets light of its own.</summary>
    public bool HasBorder(int column, int row) => (_codes[(row * Width) + column] & SampledPixels.HasBorder) != 0;

    /// <summary>Index of a pixel in <see cref="Starts"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int IndexOf(int column, int row) => ((row - FirstRow) * Width) + column;

    /// <summary>Where eight samples of a pixel lie, in columns and rows of the plane that is drawn in.</summary>
    /// <param name="index">The pixel's.</param>
    /// <param name="first">Number of the first one in its pixel.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void ReadPlaces(int column, int row, int index, int first, out Vector512<double> x, out Vector512<double> y)
    {
        if (_hasLens)
        {
            int sample = Starts[index] + first;
            (x, y) = (ArrayLanes.Load(Columns, sample), ArrayLanes.Load(Rows, sample));
        }
        else
        {
            x = ArrayLanes.Load(Pattern.Right, first) + Vector512.Create((double)column);
            y = ArrayLanes.Load(Pattern.Down, first) + Vector512.Create((double)row);
        }
    }

    /// <summary>Where four samples of a pixel lie; the parameters are those of eight.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void ReadPlaces(int column, int row, int index, int first, out Vector256<double> x, out Vector256<double> y)
    {
        if (_hasLens)
        {
            int sample = Starts[index] + first;
            (x, y) = (ArrayLanes.Load256(Columns, sample), ArrayLanes.Load256(Rows, sample));
        }
        else
        {
            x = ArrayLanes.Load256(Pattern.Right, first) + Vector256.Create((double)column);
            y = ArrayLanes.Load256(Pattern.Down, first) + Vector256.Create((double)row);
        }
    }

    /// <summary>Notes where a facet lies in the plane that is drawn in, before it is drawn as the only one of a pixel.</summary>
    public void SetPlane(int facet, in FacetPlane plane)
    {
        if (facet >= _planes.Length)
        {
            Array.Resize(ref _planes, Math.Max(2 * _planes.Length, facet + 1024));
        }

        _planes[facet] = plane;
    }

    /// <summary>Draws a facet in a pixel all of whose samples lie in it.</summary>
    /// <returns>Whether it is done: nothing is if some samples see this facet and others the one that they saw before.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool TryDrawWhole(int column, int row, int index, int facet)
    {
        ref int state = ref _states[index];
        if (state == Untouched)
        {
            state = facet;
            return true;
        }

        return state != Apart && TryReplace(ref state, column, row, facet);
    }

    private bool TryReplace(ref int state, int column, int row, int facet)
    {
        ref readonly FacetPlane before = ref _planes[state];
        ref readonly FacetPlane plane = ref _planes[facet];
        double nearer = plane.At(column, row) - before.At(column, row);
        double change = Margin * (Math.Abs(plane.PerColumn - before.PerColumn) + Math.Abs(plane.PerRow - before.PerRow));
        if (nearer > change)
        {
            state = facet;
        }

        return Math.Abs(nearer) > change;
    }

    /// <summary>The facet that all samples of a pixel see, and where it lies; false if they do not all see the same one.</summary>
    public bool TryGetWhole(int index, out int facet, out FacetPlane plane)
    {
        facet = _states[index];
        plane = facet >= 0 ? _planes[facet] : default;
        return facet >= 0;
    }

    /// <summary>Gives the samples of a pixel depths and facets of their own.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Part(int column, int row, int index)
    {
        if (_states[index] != Apart)
        {
            SetApart(column, row, index);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be drawn with unoptimised vectors
    private void SetApart(int column, int row, int index)
    {
        int facet = _states[index];
        _states[index] = Apart;
        int start = Starts[index];
        int vectors = VectorsOf(column, row);
        int count = vectors * SamplePattern.Lanes;
        if (facet == Untouched)
        {
            InverseDepths.AsSpan(start, count).Clear();
            Facets.AsSpan(start, count).Fill(Band.NotRecorded);
        }
        else
        {
            for (int sample = 0; sample < count; sample += SamplePattern.Lanes)
            {
                ReadPlaces(column, row, index, sample, out Vector512<double> x, out Vector512<double> y);
                _planes[facet].At(x, y).StoreTo(InverseDepths, start + sample);
            }

            Facets.AsSpan(start, count).Fill(facet);
        }

        // In front of what fills up the last vector no facet is ever seen.
        int samples = Pattern.SamplesIn(vectors);
        InverseDepths.AsSpan(start + samples, count - samples).Fill(double.PositiveInfinity);
    }

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
    public TangentBox PlaceInLens(CameraModel model, LensSubsamples? known)
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
                    Copy(known, column, row, start, samples);
                }

                for (int sample = 0; sample < samples; sample += SamplePattern.Lanes)
                {
                    if (known is null)
                    {
                        LanePoints ideal = model.ToIdeal(
                            ArrayLanes.Load(Pattern.Right, sample) + Vector512.Create(column + 1.0),
                            ArrayLanes.Load(Pattern.Down, sample) + Vector512.Create(row + 1.0));
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
    private void Copy(LensSubsamples known, int column, int row, int start, int samples)
    {
        int count = Pattern.Count;
        known.Read(column, row, Right, Down, start);
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
        LaneRange right = LaneRange.Nothing;
        LaneRange down = LaneRange.Nothing;
        Vector512<double> margins = Vector512<double>.Zero;
        for (int row = window.FirstRow; row <= window.LastRow; row++)
        {
            for (int column = window.FirstColumn; column <= window.LastColumn; column++)
            {
                int start = Starts[IndexOf(column, row)];
                int end = start + (VectorsOf(column, row) * SamplePattern.Lanes);
                for (int sample = start; sample < end; sample += SamplePattern.Lanes)
                {
                    Vector512<double> ofRight = ArrayLanes.Load(Right, sample);
                    Vector512<double> ofDown = ArrayLanes.Load(Down, sample);
                    (Vector512<double> x, Vector512<double> y) = tile.Map.Apply(ofRight, ofDown);
                    x.StoreTo(Columns, sample);
                    y.StoreTo(Rows, sample);
                    margins = Vector512.MaxNative(margins, Vector512.MaxNative(
                        Vector512.Abs(x - Vector512.Create((double)column)), Vector512.Abs(y - Vector512.Create((double)row))));
                    right.Widen(ofRight);
                    down.Widen(ofDown);
                }
            }
        }

        LaneRange margin = LaneRange.Nothing;
        margin.Widen(margins);
        return new LensTile(window, tile.Map, margin.Max, new TangentBox(right.Min, down.Min, right.Max, down.Max));
    }

    /// <summary>Goes on with one tile of an image with a lens.</summary>
    public void Narrow(LensTile tile)
    {
        Window = tile.Pixels;
        Margin = tile.Margin;
    }

    private void EnsureRoom()
    {
        int pixels = Width * (LastRow - FirstRow + 1);
        if (Starts.Length < pixels)
        {
            Starts = new int[pixels];
            _states = new int[pixels];
        }

        if (InverseDepths.Length < Count)
        {
            int room = Count + (Count / 4);
            InverseDepths = new double[room];
            Facets = new int[room];
        }

        if (_hasLens && Right.Length < InverseDepths.Length)
        {
            Columns = new double[InverseDepths.Length];
            Rows = new double[InverseDepths.Length];
            Right = new double[InverseDepths.Length];
            Down = new double[InverseDepths.Length];
        }
    }
}

/// <summary>Rows of an image whose further samples are drawn together.</summary>
/// <param name="FirstRow">The first row, counted from 0.</param>
/// <param name="Vectors">Number of vectors of <see cref="SamplePattern.Lanes"/> samples in them.</param>
internal readonly record struct SampledBand(int FirstRow, int LastRow, int Vectors);
