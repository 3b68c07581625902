using Msisf.Adapters.Input;

namespace Msisf.Adapters.Catalogues;

/// <summary>
/// Which columns of a list mean what, as the user says it: <c>lat=Breite,lon=Länge,diam_km=D</c>. A column is named as the list names it,
/// or by its number from 1, also in lists without names.
/// </summary>
public sealed class ListColumns
{
    /// <summary>What a column may be.</summary>
    public static readonly IReadOnlyList<string> Keys =
        ["id", "name", "lat", "lon", "diam_km", "diam_m", "major_km", "minor_km", "angle_deg", "height", "x", "y", "z"];

    private readonly (string Key, string Column)[] _pairs;

    private readonly string _text;

    private ListColumns((string Key, string Column)[] pairs, string text) => (_pairs, _text) = (pairs, text);

    /// <summary>Reads the text.</summary>
    /// <param name="text">Pairs with '=' between them, separated by commas; a column's name may be in double quotes.</param>
    /// <exception cref="BadInputException">A pair has no '=', or a key is unknown or there twice.</exception>
    public static ListColumns Parse(string text)
    {
        (string Key, string Column)[] pairs = [.. CsvLine.Fields(text, ',').Select(pair =>
        {
            string[] parts = pair.Split('=', 2, StringSplitOptions.TrimEntries);
            string key = parts[0].ToLowerInvariant();
            return parts.Length == 2 && parts[1].Length > 0 && Keys.Contains(key)
                ? (key, parts[1])
                : throw new BadInputException(
                    $"{NumberText.Shown(pair)} is not KEY=COLUMN with one of the keys {string.Join(", ", Keys)}"
                        + $"{NearestName.Question(key, Keys, otherwise: string.Empty)}.");
        })];
        return pairs.GroupBy(pair => pair.Item1).FirstOrDefault(group => group.Count() > 1) is { Key: var twice }
            ? throw new BadInputException($"'{twice}' is there twice. Leave one out.")
            : new ListColumns(pairs, text);
    }

    /// <summary>The text as the user gave it.</summary>
    public override string ToString() => _text;

    /// <summary>The place of the column that a key names, from 0; null if the user does not say it.</summary>
    /// <param name="names">The names of the list's columns.</param>
    /// <returns>-1 if the list has no such column.</returns>
    internal int? PlaceOf(string key, IReadOnlyList<string> names)
    {
        if (Array.Find(_pairs, pair => pair.Key == key).Column is not { } column)
        {
            return null;
        }

        int place = names.ToList().FindIndex(name => name.Equals(column, StringComparison.OrdinalIgnoreCase));
        return place >= 0 ? place
            : int.TryParse(column, NumberStyles.None, CultureInfo.InvariantCulture, out int number) && number >= 1 && number <= names.Count
                ? number - 1
                : -1;
    }

    /// <summary>The first column of the text that a list does not have; null if it has all.</summary>
    internal string? MissingIn(IReadOnlyList<string> names) =>
        Array.Find(_pairs, pair => PlaceOf(pair.Key, names) < 0).Column;

    /// <summary>Whether all columns are given by numbers, so that a list needs no names.</summary>
    internal bool AreNumbers => Array.TrueForAll(_pairs, pair => pair.Column.All(char.IsAsciiDigit));
}
