using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Detector.Noise;

/// <summary>Appends the places of some of eight lanes to a list.</summary>
internal static class LaneList
{
    private const int Lanes = NoiseSource.Lanes;

    /// <summary>For each set of lanes eight bytes, the numbers of its lanes first.</summary>
    private static readonly byte[] Orders = [.. Enumerable.Range(0, 1 << Lanes).SelectMany(Order)];

    /// <summary>Appends without branches, because nobody can predict them.</summary>
    /// <param name="places">The list; has room for eight more.</param>
    /// <param name="count">Number of places in it.</param>
    /// <param name="start">Place of the first lane.</param>
    /// <param name="lanes">A bit for each lane.</param>
    /// <returns>The new number of places.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Append(Span<int> places, int count, int start, uint lanes)
    {
        Vector128<ushort> order = Vector128.WidenLower(
            Vector128.CreateScalar(MemoryMarshal.Cast<byte, ulong>(Orders)[(int)lanes]).AsByte());
        Vector256<int> widened = Vector256.Create(Vector128.WidenLower(order), Vector128.WidenUpper(order)).AsInt32();
        (widened + Vector256.Create(start)).CopyTo(places.Slice(count, Lanes));
        return count + BitOperations.PopCount(lanes);
    }

    private static IEnumerable<byte> Order(int lanes) =>
        Enumerable.Range(0, Lanes).OrderBy(lane => ((lanes >> lane) & 1) == 0).Select(lane => (byte)lane);
}
