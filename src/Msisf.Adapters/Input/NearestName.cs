namespace Msisf.Adapters.Input;

/// <summary>Finds the name that a misspelt word most likely means.</summary>
public static class NearestName
{
    /// <summary>Maximum length of a word, characters: a longer word is no misspelt name, and comparing it would take long.</summary>
    private const int LongestWord = 100;

    /// <summary>
    /// The name that needs the fewest insertions, deletions and replacements of characters to be made from a word; the first if several
    /// need as few.
    /// </summary>
    /// <param name="word">The misspelt word.</param>
    /// <param name="names">The possible names, at least one.</param>
    public static string To(string word, IEnumerable<string> names)
    {
        string start = word[..Math.Min(word.Length, LongestWord)];
        return names.MinBy(name => Distance(start, name))!;
    }

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
