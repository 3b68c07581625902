using System.Runtime.CompilerServices;

namespace Msisf.Core.Render.Shadows;

/// <summary>What one thread finds of a bin of <see cref="ReceiverGrid"/> for its group of rows.</summary>
internal struct ReceiverBin
{
    /// <summary>Number of receivers; when they have their places, the index of the next one to be stored.</summary>
    public int Receivers;

    /// <summary>Maximum depth of the receivers, m.</summary>
    public float Depth;

    /// <summary>A bin without receivers.</summary>
    public static ReceiverBin Empty => new() { Depth = float.NegativeInfinity };

    /// <summary>Counts receivers.</summary>
    /// <param name="numbers">The bin of each receiver; below 0 for one that is left out.</param>
    /// <param name="depths">Their depths, m.</param>
    /// <param name="columns">Their columns in the image.</param>
    /// <param name="places">Receives the bin of each receiver at its column.</param>
    /// <param name="hide">Called with the column of each receiver that is left out.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Count(
        ReceiverBin[] bins, ReadOnlySpan<int> numbers, ReadOnlySpan<float> depths, ReadOnlySpan<int> columns, Span<int> places,
        Action<int> hide)
    {
        for (int i = 0; i < numbers.Length; i++)
        {
            places[columns[i]] = numbers[i];
            if (numbers[i] < 0)
            {
                hide(columns[i]);
                continue;
            }

            ref ReceiverBin bin = ref bins[numbers[i]];
            bin.Receivers++;
            bin.Depth = float.MaxNative(bin.Depth, depths[i]);
        }
    }
}
