using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Msisf.Core.Render.Visibility;

/// <summary>Copies from the depth buffer what the surface points of a row are computed from.</summary>
internal sealed class RowGather
{
    /// <summary>Control bytes of the instruction that joins halves of two vectors.</summary>
    private const byte LowerHalves = 0x20;

    private const byte UpperHalves = 0x31;

    private readonly LensSamples? _lens;
    private readonly double[] _right;
    private readonly int[] _columns;

    /// <summary>Makes the tables of a frame.</summary>
    /// <param name="view">The projection.</param>
    /// <param name="lens">The samples of a camera with a lens; null for a pinhole.</param>
    public RowGather(ImageView view, LensSamples? lens)
    {
        _lens = lens;
        _right = new double[view.Camera.Width];
        _columns = new int[view.Camera.Width];
        double width = view.Camera.Width;
        for (int column = 0; column < _right.Length; column++)
        {
            _columns[column] = column;
            double x = column + 1;
            _right[column] = ((2.0 * x) - 1.0 - width) / (2.0 * width);
        }
    }

    /// <summary>
    /// Copies the row's surface pixels into consecutive elements. Until the points are computed, X holds the pixels' factors of the
    /// camera's right vector and Y the offsets of their planes; with a lens Z holds the factors of the vector down.
    /// </summary>
    public void Gather(Band band, int row, SurfaceRow pixels)
    {
        int start = (row - band.FirstRow) * band.Stride;
        ReadOnlySpan<double> inverses = band.InverseDepths.AsSpan(start, band.Width);
        ReadOnlySpan<long> bits = MemoryMarshal.Cast<double, long>(inverses); // 0 without surface
        ReadOnlySpan<int> facets = band.Facets.AsSpan(start, band.Width);
        int count = 0;
        int first = 0;
        for (int gap; (gap = bits[first..].IndexOfAnyExcept(0L)) >= 0;)
        {
            first += gap;
            int run = bits[first..].IndexOf(0L);
            run = run < 0 ? bits.Length - first : run;
            _columns.AsSpan(first, run).CopyTo(pixels.Columns.AsSpan(count));
            inverses.Slice(first, run).CopyTo(pixels.Parameters.AsSpan(count));
            facets.Slice(first, run).CopyTo(pixels.Facets.AsSpan(count));
            if (_lens is null)
            {
                _right.AsSpan(first, run).CopyTo(pixels.X.AsSpan(count));
            }
            else
            {
                int sample = (row * band.Width) + first;
                _lens.Right.AsSpan(sample, run).CopyTo(pixels.X.AsSpan(count));
                _lens.Down.AsSpan(sample, run).CopyTo(pixels.Z.AsSpan(count));
            }

            count += run;
            first += run;
        }

        pixels.Count = count;
    }

    /// <summary>The same for some pixels, of the given columns.</summary>
    public void Gather(Band band, int row, ReadOnlySpan<int> columns, SurfaceRow pixels)
    {
        int start = (row - band.FirstRow) * band.Stride;
        ReadOnlySpan<double> inverses = band.InverseDepths.AsSpan(start, band.Width);
        ReadOnlySpan<int> facets = band.Facets.AsSpan(start, band.Width);
        ReadOnlySpan<double> right = _lens is null ? _right : _lens.Right.AsSpan(row * band.Width, band.Width);
        ReadOnlySpan<double> down = _lens is null ? _right : _lens.Down.AsSpan(row * band.Width, band.Width); // without a lens not used
        columns.CopyTo(pixels.Columns);
        for (int i = 0; i < columns.Length; i++)
        {
            int column = columns[i];
            pixels.Parameters[i] = inverses[column];
            pixels.Facets[i] = facets[column];
            pixels.X[i] = right[column];
            pixels.Z[i] = down[column];
        }

        pixels.Count = columns.Length;
    }

    /// <summary>Reads the planes of the pixels' facets: normals of any length, and the offsets into Y.</summary>
    public static void GatherPlanes(ReadOnlySpan<FacetRecord> records, SurfaceRow pixels)
    {
        ReadOnlySpan<int> facets = pixels.Facets.AsSpan(0, pixels.Count);
        Span<double> offsets = pixels.Y.AsSpan(0, facets.Length);
        Span<double> normalX = pixels.NormalX.AsSpan(0, facets.Length);
        Span<double> normalY = pixels.NormalY.AsSpan(0, facets.Length);
        Span<double> normalZ = pixels.NormalZ.AsSpan(0, facets.Length);
        int i = 0;
        if (Avx.IsSupported)
        {
            // A record begins with its normal and offset: four records are read as the rows of a matrix and written as its columns.
            for (; i <= facets.Length - Vector256<double>.Count; i += Vector256<double>.Count)
            {
                Vector256<double> a = PlaneOf(in records[facets[i]]);
                Vector256<double> b = PlaneOf(in records[facets[i + 1]]);
                Vector256<double> c = PlaneOf(in records[facets[i + 2]]);
                Vector256<double> d = PlaneOf(in records[facets[i + 3]]);
                Vector256<double> xzOfTwo = Avx.UnpackLow(a, b);
                Vector256<double> xzOfOthers = Avx.UnpackLow(c, d);
                Vector256<double> yOffsetOfTwo = Avx.UnpackHigh(a, b);
                Vector256<double> yOffsetOfOthers = Avx.UnpackHigh(c, d);
                Avx.Permute2x128(xzOfTwo, xzOfOthers, LowerHalves).StoreTo(normalX, i);
                Avx.Permute2x128(yOffsetOfTwo, yOffsetOfOthers, LowerHalves).StoreTo(normalY, i);
                Avx.Permute2x128(xzOfTwo, xzOfOthers, UpperHalves).StoreTo(normalZ, i);
                Avx.Permute2x128(yOffsetOfTwo, yOffsetOfOthers, UpperHalves).StoreTo(offsets, i);
            }
        }

        for (; i < facets.Length; i++)
        {
            ref readonly FacetRecord record = ref records[facets[i]];
            offsets[i] = record.Offset;
            normalX[i] = record.Normal.X;
            normalY[i] = record.Normal.Y;
            normalZ[i] = record.Normal.Z;
        }

        Pad(pixels);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> PlaneOf(in FacetRecord record) =>
        Unsafe.As<FacetRecord, Vector256<double>>(ref Unsafe.AsRef(in record));

    private static void Pad(SurfaceRow pixels)
    {
        for (int behind = pixels.Count; behind < pixels.Count + SurfaceRow.Padding; behind++)
        {
            (pixels.Parameters[behind], pixels.X[behind], pixels.Y[behind], pixels.Z[behind]) = (1.0, 0.0, 0.0, 0.0);
            (pixels.NormalX[behind], pixels.NormalY[behind], pixels.NormalZ[behind]) = (1.0, 0.0, 0.0);
        }
    }
}
