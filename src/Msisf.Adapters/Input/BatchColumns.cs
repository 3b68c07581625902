namespace Msisf.Adapters.Input;

/// <summary>The named columns of a batch file.</summary>
internal sealed class BatchColumns
{
    private readonly Dictionary<string, (int Index, string Written)> _columns = [];
    private readonly List<string> _ignored = [];

    /// <summary>Reads the header.</summary>
    /// <param name="header">The line of names, separated by commas.</param>
    /// <param name="ignoresUnknown">Whether columns that are not known are left out.</param>
    /// <exception cref="BadInputException">A name is not known, or a column stands twice.</exception>
    public BatchColumns(string header, bool ignoresUnknown)
    {
        string[] names = Fields(header);
        Count = names.Length;
        for (int index = 0; index < names.Length; index++)
        {
            string written = names[index];
            if (BatchNames.Known(written) is not { } name)
            {
                _ignored.Add(ignoresUnknown ? $"'{written}'" : throw new BadInputException(Unknown(index + 1, written)));
            }
            else if (!_columns.TryAdd(name, (index, written)))
            {
                string first = _columns[name].Written;
                string also = first.Equals(written, StringComparison.OrdinalIgnoreCase) ? string.Empty : $", as {first} too";
                throw new BadInputException($"column {index + 1}: '{written}' stands twice{also}. Remove one of them.");
            }
        }
    }

    /// <summary>Number of values in a line.</summary>
    public int Count { get; }

    /// <summary>Names of the columns that are left out, in quotes.</summary>
    public IReadOnlyList<string> Ignored => _ignored;

    /// <summary>Whether the first line of a file names columns; else it is a state of eight numbers.</summary>
    public static bool IsHeader(ReadOnlySpan<char> line) =>
        line.ContainsAny(',', ';') && !TimeText.TryParse(line[..line.IndexOfAny(',', ';')].Trim(), out _);

    /// <summary>The fields of a line, without the quotes that spreadsheets put around them.</summary>
    public static string[] Fields(string line) =>
        [.. line.Split(',', StringSplitOptions.TrimEntries).Select(field => field is ['"', .. string inner, '"'] ? inner.Trim() : field)];

    /// <summary>Whether there is a column.</summary>
    /// <param name="name">Its name of <see cref="BatchNames"/>.</param>
    public bool Has(string name) => _columns.ContainsKey(name);

    /// <summary>Where a column is, from 0, and its name as the file writes it.</summary>
    /// <param name="name">Its name of <see cref="BatchNames"/>; there must be such a column.</param>
    public (int Index, string Written) Of(string name) => _columns[name];

    private static string Unknown(int number, string written)
    {
        if (written.Length == 0)
        {
            return $"column {number} has no name. Name or remove it, or give --ignore-columns.";
        }

        if (written.Contains(';'))
        {
            return "columns and values are apart by commas, not by semicolons. Save the file with commas.";
        }

        if (written.Equals("q4", StringComparison.OrdinalIgnoreCase))
        {
            return $"column {number}: of q1 to q4 some programs mean q4 as the scalar, others q1. Name the columns qx, qy, qz, qw.";
        }

        string question = NearestName.Question(written, BatchNames.All);
        return $"column {number}: {NumberText.Shown(written)} is no column{(question.Length > 0 ? question : ".")} "
            + $"There are {string.Join(", ", BatchNames.All)}. --ignore-columns leaves others out.";
    }
}
