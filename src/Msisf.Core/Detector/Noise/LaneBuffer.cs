using System.Runtime.Intrinsics;

namespace Msisf.Core.Detector.Noise;

/// <summary>Reads and writes four numbers at a place of a row.</summary>
internal static class LaneBuffer
{
    /// <summary>Reads four numbers.</summary>
    public static Vector256<double> Load(ReadOnlySpan<double> values, int start) =>
        Vector256.Create(values.Slice(start, Vector256<double>.Count));

    /// <summary>Writes four numbers, or as many as there is room for.</summary>
    public static void Store(Vector256<double> four, Span<double> values, int start)
    {
        if (values.Length - start >= Vector256<double>.Count)
        {
            four.CopyTo(values[start..]);
            return;
        }

        for (int lane = 0; start + lane < values.Length; lane++)
        {
            values[start + lane] = four[lane];
        }
    }

    /// <summary>Appends the places of some of four lanes to a list; without branches, because nobody can predict them.</summary>
    /// <param name="places">The list; has room for four more.</param>
    /// <param name="count">Number of places in it.</param>
    /// <param name="start">Place of the first lane.</param>
    /// <param name="lanes">A bit for each lane.</param>
    /// <returns>The new number of places.</returns>
    public static int Append(Span<int> places, int count, int start, uint lanes)
    {
        Span<int> target = places.Slice(count, Vector256<double>.Count);
        int next = 0;
        target[next] = start;
        next += (int)(lanes & 1);
        target[next] = start + 1;
        next += (int)((lanes >> 1) & 1);
        target[next] = start + 2;
        next += (int)((lanes >> 2) & 1);
        target[next] = start + 3;
        return count + next + (int)((lanes >> 3) & 1);
    }
}
