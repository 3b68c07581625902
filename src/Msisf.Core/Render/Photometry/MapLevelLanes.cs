using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Reads a level of a map between its pixels, as <see cref="MapLevelReader"/> does and with the same bits, for many places at once: where
/// the pixels are and how they are mixed is found for eight places at a time, and only their codes are read one after the other. Keeps
/// buffers, so each thread needs its own object.
/// </summary>
internal sealed class MapLevelLanes
{
    /// <summary>Most places at once.</summary>
    public const int MaxPlaces = 256;

    /// <summary>With a whole number below 2^51 added, its last bits are that number.</summary>
    private const double WholeNumbers = 4503599627370496.0;

    private readonly long[] _codes = new long[MaxPlaces];
    private readonly double[] _partX = new double[MaxPlaces];
    private readonly double[] _partY = new double[MaxPlaces];

    /// <summary>Reads the codes at places.</summary>
    /// <param name="x">Distances from the left edge, pixels of the finest level; read up to a whole vector.</param>
    /// <param name="y">Distances from the upper edge.</param>
    /// <param name="codes">
    /// Receives the codes, up to a whole vector; NaN at the map's edge and where a pixel has no data, for <see cref="MapLevelReader"/>.
    /// </param>
    public void Read(
        AlbedoMapLevel level, AlbedoMapLevel finest, ReadOnlySpan<double> x, ReadOnlySpan<double> y, Span<double> codes, int count)
    {
        if (level.Width < 2 || level.Height < 2)
        {
            codes[..count].Fill(double.NaN);
            return;
        }

        FindPixels(level, finest, x, y, count);
        ReadPixels(level.Codes.Span[..(level.Width * level.Height)], level.Width, _codes.AsSpan(0, count));
        Mix(codes, count);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be shaded with unoptimised vectors
    private void FindPixels(AlbedoMapLevel level, AlbedoMapLevel finest, ReadOnlySpan<double> x, ReadOnlySpan<double> y, int count)
    {
        Vector512<double> zero = Vector512<double>.Zero;
        Vector512<double> half = Vector512.Create(0.5);
        Vector512<double> scaleX = Vector512.Create((double)level.Width / finest.Width);
        Vector512<double> scaleY = Vector512.Create((double)level.Height / finest.Height);
        Vector512<double> width = Vector512.Create((double)level.Width);
        Vector512<double> lastColumn = width - Vector512<double>.One;
        Vector512<double> lastRow = Vector512.Create(level.Height - 1.0);
        Vector512<double> wholeNumbers = Vector512.Create(WholeNumbers);
        Span<long> indices = _codes;
        Span<double> partsX = _partX;
        Span<double> partsY = _partY;
        for (int i = 0; i < count; i += Vector512<double>.Count)
        {
            Vector512<double> column = (ArrayLanes.Load(x, i) * scaleX) - half;
            Vector512<double> row = (ArrayLanes.Load(y, i) * scaleY) - half;
            Vector512<double> isInside = Vector512.GreaterThanOrEqual(Vector512.MinNative(column, row), zero)
                & Vector512.LessThan(column, lastColumn) & Vector512.LessThan(row, lastRow);
            Vector512<double> wholeColumn = Vector512.Floor(column);
            Vector512<double> wholeRow = Vector512.Floor(row);
            Vector512<double> index = isInside & ((wholeRow * width) + wholeColumn);
            ((index + wholeNumbers).AsInt64() - wholeNumbers.AsInt64()).StoreTo(indices, i);
            Vector512.ConditionalSelect(isInside, column - wholeColumn, Vector512.Create(double.NaN)).StoreTo(partsX, i);
            (row - wholeRow).StoreTo(partsY, i);
        }
    }

    /// <summary>Replaces the place of the north-western pixel by the codes of all four; all indices are inside.</summary>
    private static void ReadPixels(ReadOnlySpan<ushort> codes, int width, Span<long> indices)
    {
        ref ushort level = ref MemoryMarshal.GetReference(codes);
        ref ushort below = ref Unsafe.Add(ref level, width);
        for (int i = 0; i < indices.Length; i++)
        {
            nint index = (nint)indices[i];
            Debug.Assert(index >= 0 && index + width + 1 < codes.Length, "A pixel lies outside its level.");
            uint north = Unsafe.ReadUnaligned<uint>(ref Unsafe.As<ushort, byte>(ref Unsafe.Add(ref level, index)));
            uint south = Unsafe.ReadUnaligned<uint>(ref Unsafe.As<ushort, byte>(ref Unsafe.Add(ref below, index)));
            indices[i] = (long)(((ulong)south << 32) | north);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void Mix(Span<double> codes, int count)
    {
        ReadOnlySpan<long> packed = _codes;
        ReadOnlySpan<double> partsX = _partX;
        ReadOnlySpan<double> partsY = _partY;
        for (int i = 0; i < count; i += Vector512<double>.Count)
        {
            Vector512<long> four = ArrayLanes.Load(packed, i);
            Vector512<double> northWest = Code(four);
            Vector512<double> northEast = Code(Vector512.ShiftRightLogical(four, 16));
            Vector512<double> southWest = Code(Vector512.ShiftRightLogical(four, 32));
            Vector512<double> southEast = Code(Vector512.ShiftRightLogical(four, 48));
            Vector512<double> partX = ArrayLanes.Load(partsX, i);
            Vector512<double> north = northWest + (partX * (northEast - northWest));
            Vector512<double> south = southWest + (partX * (southEast - southWest));
            Vector512<double> code = north + (ArrayLanes.Load(partsY, i) * (south - north));
            Vector512<double> least = Vector512.MinNative(
                Vector512.MinNative(northWest, northEast), Vector512.MinNative(southWest, southEast));
            Vector512.ConditionalSelect(
                Vector512.GreaterThan(least, Vector512<double>.Zero), code, Vector512.Create(double.NaN)).StoreTo(codes, i);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Code(Vector512<long> four)
    {
        Vector512<double> wholeNumbers = Vector512.Create(WholeNumbers);
        return ((four & Vector512.Create(0xFFFFL)) | wholeNumbers.AsInt64()).AsDouble() - wholeNumbers;
    }
}
