namespace Msisf.Adapters.Catalogues;

/// <summary>A row of a list.</summary>
/// <param name="FileName">For messages.</param>
/// <param name="Header">Names of the columns.</param>
internal readonly record struct CsvRow(string FileName, ListHeader Header, int Line, List<string> Fields)
{
    /// <summary>More lines in one field are a quote that was left open.</summary>
    private const int MostLines = 20;

    /// <summary>The rows below the names; a field in quotes may go on in the lines that follow.</summary>
    /// <param name="lines">The text, at the line below the names.</param>
    /// <param name="fileName">For messages.</param>
    /// <param name="header">Names of the columns.</param>
    public static IEnumerable<CsvRow> Of(ListTable.LineSource lines, string fileName, ListHeader header)
    {
        while (lines.Read() is { } text)
        {
            int first = lines.Number;
            string whole = text;
            while (CsvLine.IsOpen(whole) && lines.Number - first < MostLines && lines.ReadAny() is { } more)
            {
                whole = $"{whole}\n{more}";
            }

            yield return new CsvRow(fileName, header, first, CsvLine.Fields(whole, header.Separator));
        }
    }

    /// <summary>A text; null where it is missing or empty.</summary>
    public string? Text(int place) =>
        place >= 0 && place < Fields.Count && Fields[place].Trim() is { Length: > 0 } text ? text : null;

    /// <summary>Whether a field is a finite number.</summary>
    public bool HasNumber(int place) => Text(place) is { } text && TryParse(text, out double value) && double.IsFinite(value);

    /// <summary>A number.</summary>
    /// <param name="place">The column.</param>
    /// <param name="least">Smallest.</param>
    /// <param name="greatest">Largest.</param>
    /// <param name="more">What else it must be, for the message.</param>
    /// <exception cref="BadInputException">It is not there, or out of range.</exception>
    public double Number(int place, double least, double greatest, string more = "") =>
        Text(place) is { } text && TryParse(text, out double value) && value >= least && value <= greatest
            ? value
            : throw Wrong(place, least, greatest, more);

    /// <summary>The error of a number.</summary>
    /// <inheritdoc cref="Number"/>
    public BadInputException Wrong(int place, double least, double greatest, string more) => new(Invariant(
        $"{FileName}, line {Line}, column '{Header.Names[place]}': a number from {least:R} to {greatest:R} is needed{more}. "
            + $"Correct or remove the line."));

    /// <summary>Where semicolons part the columns, a comma in a number is its decimal point.</summary>
    private bool TryParse(string text, out double value) => double.TryParse(
        Header.Separator == ';' && !text.Contains('.') ? text.Replace(',', '.') : text, NumberStyles.Float, CultureInfo.InvariantCulture,
        out value);
}
