namespace Msisf.Adapters.Input;

/// <summary>Finds the name that a misspelt word most likely means.</summary>
public static class NearestName
{
    /// <summary>Maximum length of a word, characters: a longer word is no misspelt name, and comparing it would take long.</summary>
    private const int LongestWord = 100;

    /// <summary>Maximum part of a word's characters that may differ for a name to be worth naming.</summary>
    private const double LargestDifference = 0.5;

    /// <summary>A question that names the nearest name, e.g. ": did you mean --renderer?"; empty if no name is near.</summary>
    /// <param name="word">The misspelt word.</param>
    /// <param name="names">The possible names.</param>
    public static string Question(string word, IReadOnlyCollection<string> names)
    {
        if (names.Count == 0 || word.Length > LongestWord)
        {
            return string.Empty;
        }

        string nearest = To(word, names);
        return Distance(Folded(word), Folded(nearest)) <= LargestDifference * word.TrimStart('-').Length
            ? $": did you mean {nearest}?"
            : string.Empty;
    }

    /// <summary>
    /// The name that needs the fewest insertions, deletions and replacements of characters to be made from a word, whatever their case; the
    /// first if several need as few.
    /// </summary>
    /// <param name="word">The misspelt word.</param>
    /// <param name="names">The possible names, at least one.</param>
    private static string To(string word, IEnumerable<string> names)
    {
        string start = Folded(word[..Math.Min(word.Length, LongestWord)]);
        return names.MinBy(name => Distance(start, Folded(name)))!;
    }

    private static string Folded(string word) => word.ToUpperInvariant();

    /// <summary>The Levenshtein distance of two words, computed row by row.</summary>
    private static int Distance(string from, string to)
    {
        int[] row = [.. Enumerable.Range(0, to.Length + 1)];
        for (int i = 0; i < from.Length; i++)
        {
            int diagonal = row[0];
            row[0] = i + 1;
            for (int j = 0; j < to.Length; j++)
            {
                int replaced = diagonal + (from[i] == to[j] ? 0 : 1);
                diagonal = row[j + 1];
                row[j + 1] = Math.Min(replaced, 1 + Math.Min(row[j], row[j + 1]));
            }
        }

        return row[^1];
    }
}
