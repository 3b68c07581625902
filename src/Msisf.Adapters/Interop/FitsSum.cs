using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Msisf.Adapters.Interop;

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
