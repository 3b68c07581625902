using System.Text;
using System.Text.Json;
using Msisf.Adapters.Ephemeris;
using Msisf.App.Settings;
using Msisf.Core.Ephemeris;

namespace Msisf.Cli.Commands;

/// <summary><c>msis kernels</c>: lists what SPICE kernels hold.</summary>
internal static class KernelsCommand
{
    private static readonly string[] Columns =
        ["file", "kind", "order", "object", "relative to", "frame", "type", "from (UTC)", "to (UTC)", ""];

    /// <summary>Runs the command.</summary>
    public static void Print(CommandCall call)
    {
        if (call.Values.Arguments.Count == 0)
        {
            throw new UsageException("msis kernels needs one kernel or more: name their files.");
        }

        bool asJson = KernelsOptions.Format.Read(call.Values);
        (IReadOnlyList<KernelContent> contents, TdbScale scale) = KernelContent.Of(
            KernelList.Expand(call.Values.Arguments), KernelList.Expand([call.Host.Installation.MetaKernel]));
        foreach (string line in asJson ? Json(contents, scale) : Table(contents, scale))
        {
            call.Host.Results.WriteLine(line);
        }
    }

    private static IEnumerable<string> Table(IReadOnlyList<KernelContent> contents, TdbScale scale)
    {
        string[][] rows = [Columns, .. contents.Select(content => Row(content, scale))];
        int[] widths = [.. Columns.Select((_, column) => rows.Max(row => row[column].Length))];
        return rows.Select(row => string.Join("  ", row.Select((cell, column) => cell.PadRight(widths[column]))).TrimEnd());
    }

    private static string[] Row(KernelContent content, TdbScale scale)
    {
        IReadOnlyList<TdbInterval> intervals = content.Cover?.Intervals ?? [];
        string gaps = intervals.Count > 1 ? Invariant($"{intervals.Count} intervals") : string.Empty;
        return
        [
            content.File, content.Kind, content.ByteOrder ?? "-", Object(content) ?? "-", content.RelativeTo ?? "-", content.Frame ?? "-",
            content.Type?.ToString(CultureInfo.InvariantCulture) ?? "-",
            intervals.Count > 0 ? Utc(intervals[0].Start, scale) : "-",
            intervals.Count > 0 ? Utc(intervals[^1].End, scale) : "-",
            content.Note ?? gaps,
        ];
    }

    private static string? Object(KernelContent content) => content.Body is not { } body ? null
        : content.Name is { } name ? Invariant($"{name} ({body})")
        : body.ToString(CultureInfo.InvariantCulture);

    /// <summary>An array with an object a line.</summary>
    private static IEnumerable<string> Json(IReadOnlyList<KernelContent> contents, TdbScale scale)
    {
        yield return "[";
        for (int index = 0; index < contents.Count; index++)
        {
            yield return $"{JsonObject(contents[index], scale)}{(index + 1 < contents.Count ? "," : string.Empty)}";
        }

        yield return "]";
    }

    private static string JsonObject(KernelContent content, TdbScale scale)
    {
        using MemoryStream stream = new();
        using (Utf8JsonWriter json = new(stream))
        {
            json.WriteStartObject();
            json.WriteString("file", content.File);
            json.WriteString("kind", content.Kind);
            json.WriteString("byte_order", content.ByteOrder);
            WriteNumber(json, "object", content.Body);
            json.WriteString("name", content.Name);
            json.WriteString("relative_to", content.RelativeTo);
            json.WriteString("frame", content.Frame);
            WriteNumber(json, "type", content.Type);
            json.WriteStartArray("intervals");
            foreach (TdbInterval interval in content.Cover?.Intervals ?? [])
            {
                json.WriteStartObject();
                json.WriteString("from_utc", Utc(interval.Start, scale));
                json.WriteString("to_utc", Utc(interval.End, scale));
                json.WriteNumber("from_tdb", interval.Start);
                json.WriteNumber("to_tdb", interval.End);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            json.WriteString("note", content.Note);
            json.WriteEndObject();
        }

        return Encoding.UTF8.GetString(stream.ToArray());
    }

    private static void WriteNumber(Utf8JsonWriter json, string name, int? number)
    {
        if (number is { } value)
        {
            json.WriteNumber(name, value);
        }
        else
        {
            json.WriteNull(name);
        }
    }

    /// <summary>Long-term kernels go past the years that a calendar date can name; then it is the number of seconds.</summary>
    private static string Utc(double tdbSeconds, TdbScale scale)
    {
        try
        {
            return scale.ToUtc(tdbSeconds).ToIsoUtc();
        }
        catch (BadInputException)
        {
            return Invariant($"TDB {tdbSeconds:R}");
        }
    }
}
