using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Msisf.Core.Detector.Noise;

/// <summary>
/// The counter-based random generator Philox4x32-10: each counter of 128 bits gives 128 random bits, without any state. Whole-number
/// arithmetic only, so every machine gets the same bits.
/// </summary>
/// <remarks>
/// J. K. Salmon, M. A. Moraes, R. O. Dror, D. E. Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC11 (2011), and Random123 1.14.
/// </remarks>
internal static class Philox4x32
{
    private const int Rounds = 10;
    private const uint FirstMultiplier = 0xD251_1F53;
    private const uint SecondMultiplier = 0xCD9E_8D57;
    private const uint FirstKeyStep = 0x9E37_79B9;
    private const uint SecondKeyStep = 0xBB67_AE85;

    /// <summary>The random words of one counter.</summary>
    /// <param name="counter">Four words of the counter.</param>
    /// <param name="key">First word of the key in the lower half, second word in the upper half.</param>
    public static (uint First, uint Second, uint Third, uint Fourth) Block(
        (uint First, uint Second, uint Third, uint Fourth) counter, ulong key)
    {
        (uint c0, uint c1, uint c2, uint c3) = counter;
        uint k0 = (uint)key;
        uint k1 = (uint)(key >> 32);
        for (int round = 0; round < Rounds; round++)
        {
            ulong first = (ulong)FirstMultiplier * c0;
            ulong second = (ulong)SecondMultiplier * c2;
            (c0, c1, c2, c3) = ((uint)(second >> 32) ^ c1 ^ k0, (uint)second, (uint)(first >> 32) ^ c3 ^ k1, (uint)first);
            k0 += FirstKeyStep;
            k1 += SecondKeyStep;
        }

        return (c0, c1, c2, c3);
    }

    /// <summary>The random words of eight counters at once, which differ in their first word; the same words as of one.</summary>
    /// <param name="words">
    /// First word of each counter, in the lower half of its lane; becomes the first random word. The upper halves are undefined.
    /// </param>
    /// <param name="second">Second word of all counters; becomes the second random words.</param>
    /// <param name="third">Third word of all counters; becomes the third random words.</param>
    /// <param name="fourth">Fourth word of all counters; becomes the fourth random words.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Blocks(
        ref Vector512<ulong> words, ref Vector512<ulong> second, ref Vector512<ulong> third, ref Vector512<ulong> fourth, ulong key)
    {
        Vector512<ulong> c0 = words;
        Vector512<ulong> c1 = second;
        Vector512<ulong> c2 = third;
        Vector512<ulong> c3 = fourth;
        Vector512<ulong> firstMultiplier = Vector512.Create((ulong)FirstMultiplier);
        Vector512<ulong> secondMultiplier = Vector512.Create((ulong)SecondMultiplier);

        // The upper halves of the lanes run over without harm: no lane takes anything from an upper half.
        Vector512<ulong> k0 = Vector512.Create(key);
        Vector512<ulong> k1 = Vector512.Create(key >> 32);
        for (int round = 0; round < Rounds; round++)
        {
            Vector512<ulong> left = MultiplyWords(firstMultiplier, c0);
            Vector512<ulong> right = MultiplyWords(secondMultiplier, c2);
            c0 = (right >>> 32) ^ c1 ^ k0;
            c1 = right;
            c2 = (left >>> 32) ^ c3 ^ k1;
            c3 = left;
            k0 += Vector512.Create((ulong)FirstKeyStep);
            k1 += Vector512.Create((ulong)SecondKeyStep);
        }

        words = c0;
        second = c1;
        third = c2;
        fourth = c3;
    }

    /// <summary>Products of the lower halves of the lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<ulong> MultiplyWords(Vector512<ulong> a, Vector512<ulong> b)
    {
        if (Avx512F.IsSupported)
        {
            return Avx512F.Multiply(a.AsUInt32(), b.AsUInt32());
        }

        if (Avx2.IsSupported)
        {
            return Vector512.Create(
                Avx2.Multiply(a.GetLower().AsUInt32(), b.GetLower().AsUInt32()),
                Avx2.Multiply(a.GetUpper().AsUInt32(), b.GetUpper().AsUInt32()));
        }

        Vector512<ulong> word = Vector512.Create((ulong)uint.MaxValue);
        return (a & word) * (b & word);
    }
}
