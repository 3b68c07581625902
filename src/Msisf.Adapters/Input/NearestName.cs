namespace Msisf.Adapters.Input;

/// <summary>Finds the name that a misspelt word most likely means.</summary>
public static class NearestName
{
    /// <summary>Maximum length of a word, characters: a longer word is not a misspelt name, and comparing it would take long.</summary>
    private const int LongestWord = 100;

    /// <summary>Maximum part of a word's characters that may differ for a name to be worth naming.</summary>
    private const double LargestDifference = 0.5;

    /// <summary>
    /// A question that names the nearest name, e.g. ": did you mean --renderer?". It is the one that needs the fewest insertions,
    /// deletions and replacements of characters, whatever their case; the first if several need as few.
    /// </summary>
    /// <param name="word">The misspelt word.</param>
    /// <param name="names">The possible names.</param>
    /// <param name="otherwise">What is in the question's place if no name is near.</param>
    public static string Question(string word, IReadOnlyCollection<string> names, string otherwise = "")
    {
        if (names.Count == 0 || word.Length > LongestWord)
        {
            return otherwise;
        }

        string nearest = names.MinBy(name => Distance(Folded(word), Folded(name)))!;
        return Distance(Folded(word), Folded(nearest)) <= LargestDifference * word.TrimStart('-').Length
            ? $": did you mean {nearest}?"
            : otherwise;
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
