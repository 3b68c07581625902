namespace Msisf.Core.Scene;

/// <summary>Some steps of a run, as text "3:5,17": single steps and ranges with both ends, from 1. Sorted, without duplicates.</summary>
public sealed class StepRanges
{
    private readonly (int First, int Last)[] _ranges;

    private StepRanges(IEnumerable<(int First, int Last)> ranges)
    {
        List<(int First, int Last)> merged = [];
        foreach ((int first, int last) in ranges.Order())
        {
            if (merged.Count > 0 && first <= (long)merged[^1].Last + 1)
            {
                merged[^1] = (merged[^1].First, Math.Max(last, merged[^1].Last));
            }
            else
            {
                merged.Add((first, last));
            }
        }

        _ranges = [.. merged];
    }

    /// <summary>The maximum step; 0 if there is none.</summary>
    public int Last => _ranges.Length > 0 ? _ranges[^1].Last : 0;

    /// <summary>The steps, ascending.</summary>
    public IEnumerable<int> Steps => _ranges.SelectMany(range => Enumerable.Range(range.First, range.Last - range.First + 1));

    /// <summary>Collects steps.</summary>
    /// <param name="steps">From 1, in any order.</param>
    public static StepRanges Of(IEnumerable<int> steps) => new(steps.Select(step => (step, step)));

    /// <summary>Reads the text form.</summary>
    /// <param name="text">E.g. "1001:2000" or "3:5,17".</param>
    /// <exception cref="BadInputException">The text names no steps.</exception>
    public static StepRanges Parse(string text) =>
        new(text.Split(',', StringSplitOptions.TrimEntries).Select(word => ParseRange(word, text)));

    /// <summary>The shortest text that <see cref="Parse"/> reads back.</summary>
    public override string ToString() => string.Join(',', _ranges.Select(range => range.First == range.Last
        ? Invariant($"{range.First}")
        : Invariant($"{range.First}:{range.Last}")));

    private static (int First, int Last) ParseRange(string word, string text)
    {
        string[] ends = word.Split(':', StringSplitOptions.TrimEntries);
        if (ends.Length > 2 || !TryStep(ends[0], out int first) || !TryStep(ends[^1], out int last))
        {
            throw new BadInputException(
                $"'{text}' names no steps; steps and ranges of them are needed, from 1, as in 1001:2000 or 3:5,17.");
        }

        return first <= last
            ? (first, last)
            : throw new BadInputException($"'{text}': the range {word} ends before it begins. Swap its ends.");
    }

    private static bool TryStep(string text, out int step) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out step) && step >= 1;
}
