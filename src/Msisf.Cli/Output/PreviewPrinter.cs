using System.Text;
using System.Text.Json;
using Msisf.App.Preview;
using Msisf.App.Settings;

namespace Msisf.Cli.Output;

/// <summary>Prints what the images of a run would show, a line for each.</summary>
internal static class PreviewPrinter
{
    private const string Step = "step";
    private const string Camera = "camera";
    private const string Time = "utc";

    /// <summary>What the table has where a number is undefined.</summary>
    private const string Undefined = "-";

    /// <summary>Prints rows.</summary>
    /// <param name="rows">The rows, in the order of the frames.</param>
    /// <param name="format">Their form.</param>
    /// <param name="results">Receives them.</param>
    public static void Print(IReadOnlyList<PreviewRow> rows, PreviewFormat format, TextWriter results)
    {
        IReadOnlyList<PreviewColumn> columns = PreviewColumn.Of(rows);
        foreach (string line in format switch
        {
            PreviewFormat.Csv => Csv(rows, columns),
            PreviewFormat.Json => Json(rows, columns),
            _ => Table(rows, columns),
        })
        {
            results.WriteLine(line);
        }
    }

    private static IEnumerable<string> Csv(IReadOnlyList<PreviewRow> rows, IReadOnlyList<PreviewColumn> columns) => rows
        .Select(row => Joined([.. Named(row), row.Time.ToIsoUtc()], columns, column => Text(column.ValueOf(row), "R")))
        .Prepend(Joined([Step, .. rows[0].Camera is null ? (string[])[] : [Camera], Time], columns, column => column.Name));

    private static string Joined(string[] first, IReadOnlyList<PreviewColumn> columns, Func<PreviewColumn, string> textOf) =>
        string.Join(',', (string[])[.. first, .. columns.Select(textOf)]);

    /// <summary>The step, and the camera of a rig.</summary>
    private static string[] Named(PreviewRow row) => row.Camera is { } camera ? [Text(row.Step, "F0"), camera] : [Text(row.Step, "F0")];

    /// <summary>An array with an object a line.</summary>
    private static IEnumerable<string> Json(IReadOnlyList<PreviewRow> rows, IReadOnlyList<PreviewColumn> columns)
    {
        yield return "[";
        for (int index = 0; index < rows.Count; index++)
        {
            yield return $"{JsonObject(rows[index], columns)}{(index + 1 < rows.Count ? "," : string.Empty)}";
        }

        yield return "]";
    }

    private static string JsonObject(PreviewRow row, IReadOnlyList<PreviewColumn> columns)
    {
        using MemoryStream stream = new();
        using (Utf8JsonWriter json = new(stream))
        {
            json.WriteStartObject();
            json.WriteNumber(Step, row.Step);
            if (row.Camera is { } camera)
            {
                json.WriteString(Camera, camera);
            }

            json.WriteString(Time, row.Time.ToIsoUtc());
            foreach (PreviewColumn column in columns)
            {
                if (column.ValueOf(row) is { } number)
                {
                    json.WriteNumber(column.Name, number);
                }
                else
                {
                    json.WriteNull(column.Name);
                }
            }

            json.WriteEndObject();
        }

        return Encoding.UTF8.GetString(stream.ToArray());
    }

    private static IEnumerable<string> Table(IReadOnlyList<PreviewRow> rows, IReadOnlyList<PreviewColumn> columns)
    {
        bool isRig = rows[0].Camera is not null;
        string[][] cells =
        [
            [Step, .. isRig ? (string[])[Camera] : [], "time", .. columns.Select(column => column.Heading)],
            [string.Empty, .. isRig ? (string[])[string.Empty] : [], "UTC", .. columns.Select(column => column.Unit)],
            .. rows.Select(row => (string[])
            [
                .. Named(row), row.Time.ToIsoUtc(), .. columns.Select(column => TableCell(column, row)),
            ]),
        ];
        int[] widths = [.. Enumerable.Range(0, cells[0].Length).Select(column => cells.Max(line => line[column].Length))];
        return cells.Select(line => string.Join("  ", line.Zip(widths, (cell, width) => cell.PadLeft(width))));
    }

    private static string TableCell(PreviewColumn column, PreviewRow row) =>
        column.ValueOf(row) is { } number ? Text(number, Invariant($"F{column.Decimals}")) : Undefined;

    /// <summary>A number; empty if it is undefined.</summary>
    private static string Text(double? number, string format) => number?.ToString(format, CultureInfo.InvariantCulture) ?? string.Empty;
}
