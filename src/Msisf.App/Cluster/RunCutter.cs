using Msisf.Core.Scene;

namespace Msisf.App.Cluster;

/// <summary>Cuts the steps of a run into contiguous pieces.</summary>
internal static class RunCutter
{
    /// <summary>Pieces of equal counts.</summary>
    /// <param name="steps">Ascending.</param>
    /// <param name="pieces">How many; no more than there are steps are made.</param>
    /// <returns>None is empty; the counts differ by 1 at most.</returns>
    public static IReadOnlyList<StepRanges> ByCount(IReadOnlyList<int> steps, int pieces)
    {
        int count = Math.Min(pieces, steps.Count);
        return [.. Enumerable.Range(0, count).Select(piece => Of(steps, StartOf(piece), StartOf(piece + 1)))];

        int StartOf(int piece) => (int)((long)steps.Count * piece / count);
    }

    /// <summary>Pieces of a given count; the last one may have less.</summary>
    public static IReadOnlyList<StepRanges> BySize(IReadOnlyList<int> steps, int size) =>
        [.. steps.Chunk(size).Select(StepRanges.Of)];

    private static StepRanges Of(IReadOnlyList<int> steps, int start, int end) =>
        StepRanges.Of(Enumerable.Range(start, end - start).Select(index => steps[index]));
}
