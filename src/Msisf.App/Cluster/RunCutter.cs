using Msisf.Core.Scene;

namespace Msisf.App.Cluster;

/// <summary>Cuts the steps of a run into contiguous pieces.</summary>
internal static class RunCutter
{
    /// <summary>Cuts the steps into a given number of pieces of nearly equal size.</summary>
    /// <param name="steps">The steps, ascending.</param>
    /// <param name="pieces">Number of pieces; with fewer steps than this, one piece per step is made.</param>
    /// <returns>The pieces; none is empty, and their sizes differ by 1 at most.</returns>
    public static IReadOnlyList<StepRanges> ByCount(IReadOnlyList<int> steps, int pieces)
    {
        int count = Math.Min(pieces, steps.Count);
        return [.. Enumerable.Range(0, count).Select(piece => Of(steps, StartOf(piece), StartOf(piece + 1)))];

        int StartOf(int piece) => (int)((long)steps.Count * piece / count);
    }

    /// <summary>Cuts the steps into pieces of a given size; the last one may be smaller.</summary>
    public static IReadOnlyList<StepRanges> BySize(IReadOnlyList<int> steps, int size) =>
        [.. steps.Chunk(size).Select(StepRanges.Of)];

    private static StepRanges Of(IReadOnlyList<int> steps, int start, int end) =>
        StepRanges.Of(Enumerable.Range(start, end - start).Select(index => steps[index]));
}
