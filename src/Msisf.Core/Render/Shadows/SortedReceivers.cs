using System.Diagnostics;
using System.Runtime.CompilerServices;
using Msisf.Core.Parallel;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// The receivers of a frame, sorted by bins: those in neighbouring bins of a row are contiguous in the arrays, so that a facet can be
/// tested against eight of them at a time. Valid until the next frame.
/// </summary>
/// <param name="placed">The receivers before they were sorted.</param>
/// <param name="arrays">Their coordinates and pixels.</param>
/// <param name="starts">Where each bin begins in the arrays, and the end.</param>
internal sealed class SortedReceivers(PlacedReceivers placed, ReceiverArrays arrays, int[] starts)
{
    private const int LaneCount = 8;

    /// <summary>Light space of the frame.</summary>
    public LightFrame Frame { get; } = placed.Frame;

    /// <summary>Bounds of all receivers, m.</summary>
    public LightBox Box { get; } = placed.Box;

    public DepthGrid Bins { get; } = placed.Bins;

    public int Length { get; } = starts[placed.Bins.Size * placed.Bins.Size];

    /// <inheritdoc cref="ReceiverArrays.U"/>
    public double[] U { get; } = arrays.U;

    /// <inheritdoc cref="ReceiverArrays.U"/>
    public double[] V { get; } = arrays.V;

    /// <inheritdoc cref="ReceiverArrays.U"/>
    public double[] W { get; } = arrays.W;

    /// <inheritdoc cref="ReceiverArrays.Pixels"/>
    public int[] Pixels { get; } = arrays.Pixels;

    /// <summary>Mask of the lanes before <paramref name="end"/> in a vector that begins at <paramref name="receiver"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Meant(int receiver, int end) => (1u << Math.Min(end - receiver, LaneCount)) - 1;

    /// <summary>Excludes a receiver from further tests: its depth becomes minus infinity. Several threads may call it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void TakeOut(int receiver) => W[receiver] = double.NegativeInfinity;

    /// <summary>The range in the arrays of the receivers in neighbouring bins of a row.</summary>
    /// <returns>Index of the first receiver and one past the last.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (int First, int End) Run(int row, int firstColumn, int lastColumn)
    {
        Debug.Assert(row >= 0 && row < Bins.Size && firstColumn >= 0 && lastColumn < Bins.Size, "A bin lies outside the grid.");
        int start = row * Bins.Size;
        return (ArrayLanes.At(starts, start + firstColumn), ArrayLanes.At(starts, start + lastColumn + 1));
    }
}

/// <summary>Memory for the receivers of a frame, which is kept for the next one.</summary>
internal sealed class ReceiverArrays
{
    private readonly RecentUse _use = new();

    /// <summary>
    /// Coordinate of each receiver in light space, m. The array has room for eight unused values after the last receiver, so that a
    /// vector can be read from any receiver of a <see cref="SortedReceivers.Run"/> without range checks.
    /// </summary>
    public double[] U { get; private set; } = [];

    /// <inheritdoc cref="U"/>
    public double[] V { get; private set; } = [];

    /// <inheritdoc cref="U"/>
    public double[] W { get; private set; } = [];

    /// <summary>Pixel of each receiver: row of the image times its width plus column.</summary>
    public int[] Pixels { get; private set; } = [];

    /// <summary>Bytes of the arrays that were replaced by smaller or larger ones.</summary>
    public long ReplacedBytes { get; private set; }

    /// <summary>Makes room; gives back memory that the last frames did not need.</summary>
    /// <param name="used">Number of values that are used.</param>
    /// <param name="max">Maximum of that number in frames of this size.</param>
    public void MakeRoom(int used, int max)
    {
        int length = used > U.Length ? Math.Min(RecentUse.WithReserve(used), max) : U.Length;
        if (_use.Note(used, ref length) || length != U.Length)
        {
            ReplacedBytes += U.Length * ((3L * sizeof(double)) + sizeof(int));
            U = GC.AllocateUninitializedArray<double>(length);
            V = GC.AllocateUninitializedArray<double>(length);
            W = GC.AllocateUninitializedArray<double>(length);
            Pixels = GC.AllocateUninitializedArray<int>(length);
        }
    }
}
