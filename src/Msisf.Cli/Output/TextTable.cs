using System.Text.Json.Nodes;

namespace Msisf.Cli.Output;

/// <summary>Rows for people, in columns, or for programs, as JSON.</summary>
internal static class TextTable
{
    public static void Print(TextWriter results, IEnumerable<string> lines)
    {
        foreach (string line in lines)
        {
            results.WriteLine(line);
        }
    }

    /// <summary>Lines with two blanks between their columns.</summary>
    /// <param name="rows">Their cells, the heading first.</param>
    /// <param name="isRight">Whether cells end at the same place, as numbers do.</param>
    public static IEnumerable<string> Columns(string[][] rows, bool isRight)
    {
        int[] widths = [.. Enumerable.Range(0, rows[0].Length).Select(column => rows.Max(row => row[column].Length))];
        return rows.Select(row => string.Join("  ", row.Zip(
            widths, (cell, width) => isRight ? cell.PadLeft(width) : cell.PadRight(width))).TrimEnd());
    }

    /// <summary>An array with an object a line.</summary>
    public static IEnumerable<string> Json(IEnumerable<JsonObject> rows)
    {
        string[] lines = [.. rows.Select(row => row.ToJsonString())];
        return ["[", .. lines.Select((line, index) => index + 1 < lines.Length ? $"{line}," : line), "]"];
    }
}
