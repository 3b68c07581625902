namespace Msisf.Adapters.Catalogues;

/// <summary>A line of a table with named columns.</summary>
/// <param name="FileName">For messages.</param>
/// <param name="Header">Names of the columns, in small letters.</param>
internal readonly record struct CsvRow(string FileName, IReadOnlyList<string> Header, int Line, List<string> Fields)
{
    /// <summary>More lines in one field are a quote that was left open.</summary>
    private const int MostLines = 20;

    /// <summary>The lines below the heading that are not empty; a field in quotes may go on in the lines that follow.</summary>
    /// <param name="reader">The text, at the line below the heading.</param>
    /// <param name="fileName">For messages.</param>
    /// <param name="header">Names of the columns.</param>
    public static IEnumerable<CsvRow> Of(TextReader reader, string fileName, IReadOnlyList<string> header)
    {
        int line = 1;
        while (reader.ReadLine() is { } text)
        {
            int first = ++line;
            string whole = text;
            while (CsvLine.IsOpen(whole) && line - first < MostLines && reader.ReadLine() is { } more)
            {
                whole = $"{whole}\n{more}";
                line++;
            }

            if (whole.Trim().Length > 0)
            {
                yield return new CsvRow(fileName, header, first, CsvLine.Fields(whole));
            }
        }
    }

    /// <summary>The names of the columns.</summary>
    public static IReadOnlyList<string> HeaderOf(TextReader reader) =>
        [.. CsvLine.Fields(reader.ReadLine() ?? string.Empty).Select(name => name.Trim().ToLowerInvariant())];

    /// <summary>The place of the first of some names that there is; -1 for none.</summary>
    public static int PlaceOf(IReadOnlyList<string> header, params ReadOnlySpan<string> names)
    {
        foreach (string name in names)
        {
            for (int place = 0; place < header.Count; place++)
            {
                if (header[place] == name)
                {
                    return place;
                }
            }
        }

        return -1;
    }

    /// <summary>A text; null where it is missing or empty.</summary>
    public string? Text(int place) =>
        place >= 0 && place < Fields.Count && Fields[place].Trim() is { Length: > 0 } text ? text : null;

    /// <summary>Whether a field is a finite number.</summary>
    public bool HasNumber(int place) => Text(place) is { } text
        && double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && double.IsFinite(value);

    /// <summary>A number.</summary>
    /// <param name="place">The column.</param>
    /// <param name="least">Smallest.</param>
    /// <param name="greatest">Largest.</param>
    /// <param name="more">What else it must be, for the message.</param>
    /// <exception cref="BadInputException">It is not there, or out of range.</exception>
    public double Number(int place, double least, double greatest, string more = "") =>
        Text(place) is { } text && double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
        && value >= least && value <= greatest
            ? value
            : throw Wrong(place, least, greatest, more);

    /// <summary>The error of a number.</summary>
    /// <inheritdoc cref="Number"/>
    public BadInputException Wrong(int place, double least, double greatest, string more) => new(Invariant(
        $"{FileName}, line {Line}, column '{Header[place]}': a number from {least:R} to {greatest:R} is needed{more}. "
            + $"Correct or remove the line."));
}
