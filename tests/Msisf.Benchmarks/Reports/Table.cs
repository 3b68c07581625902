using System.Text;

namespace Msisf.Benchmarks.Reports;

/// <summary>A table of texts, as Markdown or as CSV.</summary>
internal sealed class Table
{
    private readonly List<IReadOnlyList<string>> _rows = [];

    public Table(params string[] header) => _rows.Add(header);

    public void Add(params string[] row)
    {
        ArgumentOutOfRangeException.ThrowIfNotEqual(row.Length, _rows[0].Count, nameof(row));
        _rows.Add(row);
    }

    public string ToMarkdown()
    {
        StringBuilder text = new();
        for (int row = 0; row < _rows.Count; row++)
        {
            text.Append("| ").AppendJoin(" | ", _rows[row]).Append(" |\n");
            if (row == 0)
            {
                text.Append('|').Insert(text.Length, "---|", _rows[0].Count).Append('\n');
            }
        }

        return text.ToString();
    }

    public string ToCsv()
    {
        StringBuilder text = new();
        foreach (IReadOnlyList<string> row in _rows)
        {
            text.AppendJoin(',', row.Select(Quoted)).Append('\n');
        }

        return text.ToString();
    }

    /// <summary>RFC 4180.</summary>
    private static string Quoted(string field) =>
        field.AsSpan().IndexOfAny(",\"\n") < 0 ? field : $"\"{field.Replace("\"", "\"\"", StringComparison.Ordinal)}\"";
}
