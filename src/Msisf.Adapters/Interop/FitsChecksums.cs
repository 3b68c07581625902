using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Text;

namespace Msisf.Adapters.Interop;

/// <summary>Writes the checksums of a unit as ffpcks does, but without the time of day that its comments have.</summary>
internal static unsafe class FitsChecksums
{
    /// <summary>CFITSIO's name for a comment that stays.</summary>
    private const string Unchanged = "&";

    /// <summary>Writes both, of what CFITSIO has in memory.</summary>
    /// <param name="file">The file; <see cref="CFitsio.Gate"/> is held.</param>
    public static void Put(CFitsioHandle file, ref int status)
    {
        PutEmpty(file, ref status);
        CFitsioNative.ffgcks(file, out nuint dataSum, out _, ref status);
        CFitsioNative.ffmkys(file, "DATASUM", dataSum.ToString(CultureInfo.InvariantCulture), Unchanged, ref status);
        CFitsioNative.ffgcks(file, out _, out nuint unitSum, ref status);
        byte* text = stackalloc byte[CFitsioNative.ChecksumLength];
        CFitsioNative.ffesum(unitSum, complement: 1, text);
        CFitsioNative.ffmkys(file, "CHECKSUM", Encoding.ASCII.GetString(text, CFitsioNative.ChecksumLength - 1), Unchanged, ref status);
    }

    /// <summary>Writes that of the data, and zeros in place of that of the unit.</summary>
    /// <param name="file">The file; <see cref="CFitsio.Gate"/> is held.</param>
    /// <param name="dataSum">That of data that CFITSIO does not have.</param>
    /// <param name="status">CFITSIO's status.</param>
    public static void PutDataSum(CFitsioHandle file, uint dataSum, ref int status)
    {
        PutEmpty(file, ref status);
        CFitsioNative.ffmkys(file, "DATASUM", dataSum.ToString(CultureInfo.InvariantCulture), Unchanged, ref status);
        CFitsioNative.ffflus(file, ref status);
    }

    private static void PutEmpty(CFitsioHandle file, ref int status)
    {
        CFitsioNative.ffpkys(file, "CHECKSUM", "0000000000000000", "HDU checksum", ref status);
        CFitsioNative.ffpkys(file, "DATASUM", "0", "data unit checksum", ref status);
        CFitsioNative.ffflus(file, ref status); // writes the END card behind them, and the fill behind the data
    }
}

/// <summary>Changes values in the cards of a FITS header that is in memory.</summary>
internal static class FitsCards
{
    private const int CardLength = 80;

    /// <summary>Column of a value that is a text, behind its apostrophe.</summary>
    private const int TextColumn = 11;

    /// <summary>First column of a whole number, and one past its last one.</summary>
    private const int NumberColumn = 10;

    private const int NumberEnd = 30;

    /// <summary>Changes a whole number.</summary>
    /// <exception cref="ExternalPartException">The header does not have it.</exception>
    public static void SetNumber(Span<byte> header, string key, long value)
    {
        string text = value.ToString(CultureInfo.InvariantCulture).PadLeft(NumberEnd - NumberColumn);
        Encoding.ASCII.GetBytes(text, CardOf(header, key)[NumberColumn..NumberEnd]);
    }

    /// <summary>Changes a text into another one of the same length.</summary>
    /// <exception cref="ExternalPartException">The header does not have it.</exception>
    public static void SetText(Span<byte> header, string key, ReadOnlySpan<byte> text) => text.CopyTo(CardOf(header, key)[TextColumn..]);

    private static Span<byte> CardOf(Span<byte> header, string key)
    {
        Span<byte> name = stackalloc byte[NumberColumn];
        Encoding.ASCII.GetBytes($"{key,-8}= ", name);
        for (int start = 0; start < header.Length; start += CardLength)
        {
            if (header.Slice(start, CardLength).StartsWith(name))
            {
                return header.Slice(start, CardLength);
            }
        }

        throw new ExternalPartException($"CFITSIO has made a header without {key}.");
    }
}

/// <summary>The checksum of the FITS standard 4.0, appendix J: the ones' complement sum of the words of 32 bits.</summary>
internal static class FitsSum
{
    /// <summary>Pairs of words that are summed at once.</summary>
    private const int BlockLength = 512;

    /// <summary>The sum of bytes; missing ones of the last word count as 0.</summary>
    public static uint Of(ReadOnlySpan<byte> bytes)
    {
        ulong sum = 0;
        Span<ulong> block = stackalloc ulong[BlockLength];
        ReadOnlySpan<ulong> pairs = MemoryMarshal.Cast<byte, ulong>(bytes);
        for (int first = 0; first < pairs.Length; first += BlockLength)
        {
            scoped ReadOnlySpan<ulong> some = pairs.Slice(first, Math.Min(BlockLength, pairs.Length - first));
            if (BitConverter.IsLittleEndian)
            {
                BinaryPrimitives.ReverseEndianness(some, block);
                some = block[..some.Length];
            }

            sum = Folded(sum + OfPairs(some));
        }

        Span<byte> rest = stackalloc byte[sizeof(ulong)];
        rest.Clear();
        bytes[(pairs.Length * sizeof(ulong))..].CopyTo(rest);
        ulong last = BinaryPrimitives.ReadUInt64BigEndian(rest);
        return (uint)Folded(sum + Folded(last));
    }

    /// <summary>The sum of bytes that begin at an offset of the data; it can be added to those of the others.</summary>
    public static uint Of(ReadOnlySpan<byte> bytes, long offset) =>
        uint.RotateRight(Of(bytes), (int)(offset % sizeof(uint)) * 8); // bytes that move by one are worth a 256th, in a ring

    /// <summary>The sum of two.</summary>
    public static uint Of(uint a, uint b) => (uint)Folded((ulong)a + b);

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // tens of MB a frame, from the first one on
    private static ulong OfPairs(ReadOnlySpan<ulong> pairs)
    {
        Vector256<ulong> sums = Vector256<ulong>.Zero;
        int i = 0;
        for (; i <= pairs.Length - Vector256<ulong>.Count; i += Vector256<ulong>.Count)
        {
            Vector256<ulong> four = Vector256.Create(pairs[i..]);
            sums += Vector256.ShiftRightLogical(four, 32) + (four & Vector256.Create((ulong)uint.MaxValue));
        }

        ulong sum = Vector256.Sum(sums);
        for (; i < pairs.Length; i++)
        {
            sum += (pairs[i] >> 32) + (uint)pairs[i];
        }

        return sum;
    }

    /// <summary>Adds what goes beyond 32 bits to the lower end.</summary>
    private static ulong Folded(ulong sum)
    {
        while (sum > uint.MaxValue)
        {
            sum = (sum >> 32) + (uint)sum;
        }

        return sum;
    }
}
