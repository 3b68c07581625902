using Msisf.Core.Scene;

namespace Msisf.Cli.Pieces;

/// <summary>Cuts the steps of a run into contiguous pieces.</summary>
internal static class RunCutter
{
    /// <summary>Halvings of the limit: past them the two ends are neighbouring doubles.</summary>
    private const int MaxHalvings = 128;

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

    /// <summary>Pieces whose maximum cost is as small as contiguous pieces allow.</summary>
    /// <param name="steps">Ascending.</param>
    /// <param name="costs">Of each step, positive.</param>
    /// <param name="pieces">How many; no more than there are steps are made.</param>
    /// <returns>None is empty.</returns>
    public static IReadOnlyList<StepRanges> ByCost(IReadOnlyList<int> steps, IReadOnlyList<double> costs, int pieces)
    {
        int count = Math.Min(pieces, steps.Count);
        double limit = SmallestLimit(costs, count);
        List<StepRanges> cut = [];
        int start = 0;
        while (start < steps.Count)
        {
            // A piece that takes all it may could leave less than a step for each piece after it.
            int end = Math.Min(EndWithin(costs, start, limit), steps.Count - (count - cut.Count - 1));
            cut.Add(Of(steps, start, end));
            start = end;
        }

        return cut;
    }

    /// <summary>The minimum limit with which so many pieces suffice, by bisection: filling each piece up is the best that a limit allows.</summary>
    private static double SmallestLimit(IReadOnlyList<double> costs, int pieces)
    {
        double tooSmall = 0.0;
        double enough = costs.Sum();
        for (int halving = 0; halving < MaxHalvings; halving++)
        {
            double middle = tooSmall + ((enough - tooSmall) / 2.0);
            if (middle <= tooSmall || middle >= enough)
            {
                break;
            }

            if (Suffices(costs, middle, pieces))
            {
                enough = middle;
            }
            else
            {
                tooSmall = middle;
            }
        }

        return enough;
    }

    private static bool Suffices(IReadOnlyList<double> costs, double limit, int pieces)
    {
        int start = 0;
        for (int piece = 0; piece < pieces && start < costs.Count; piece++)
        {
            if (costs[start] > limit)
            {
                return false;
            }

            start = EndWithin(costs, start, limit);
        }

        return start == costs.Count;
    }

    /// <summary>Where a piece ends that is filled up to a limit; it has one step at least.</summary>
    private static int EndWithin(IReadOnlyList<double> costs, int start, double limit)
    {
        int end = start + 1;
        for (double sum = costs[start]; end < costs.Count && sum + costs[end] <= limit; end++)
        {
            sum += costs[end];
        }

        return end;
    }

    private static StepRanges Of(IReadOnlyList<int> steps, int start, int end) =>
        StepRanges.Of(Enumerable.Range(start, end - start).Select(index => steps[index]));
}
