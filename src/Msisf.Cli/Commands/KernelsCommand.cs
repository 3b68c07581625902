using System.Text.Json.Nodes;
using Msisf.Adapters.Ephemeris;
using Msisf.App.Settings;
using Msisf.Cli.Output;
using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Cli.Commands;

/// <summary><c>msis kernels</c>: lists what SPICE kernels hold.</summary>
internal static class KernelsCommand
{
    private static readonly string[] Columns =
        ["file", "kind", "order", "object", "relative to", "frame", "type", "from (UTC)", "to (UTC)", ""];

    public static void Print(CommandCall call)
    {
        if (call.Values.Arguments.Count == 0)
        {
            throw new UsageException("msis kernels needs one kernel or more: name their files.");
        }

        bool asJson = TableOptions.Format.Read(call.Values);
        (IReadOnlyList<KernelContent> contents, TimeScale scale) = KernelContent.Of(
            KernelList.Expand(call.Values.Arguments), KernelList.Expand([call.Host.Installation.MetaKernel]));
        TextTable.Print(call.Host.Results, asJson
            ? TextTable.Json(contents.Select(content => JsonOf(content, scale)))
            : TextTable.Columns([Columns, .. contents.Select(content => Row(content, scale))], isRight: false));
    }

    private static string[] Row(KernelContent content, TimeScale scale)
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

    private static JsonObject JsonOf(KernelContent content, TimeScale scale) => new()
    {
        ["file"] = content.File,
        ["kind"] = content.Kind,
        ["byte_order"] = content.ByteOrder,
        ["object"] = content.Body,
        ["name"] = content.Name,
        ["relative_to"] = content.RelativeTo,
        ["frame"] = content.Frame,
        ["type"] = content.Type,
        ["intervals"] = new JsonArray([.. (content.Cover?.Intervals ?? []).Select(interval => new JsonObject
        {
            ["from_utc"] = Utc(interval.Start, scale),
            ["to_utc"] = Utc(interval.End, scale),
            ["from_tdb"] = interval.Start,
            ["to_tdb"] = interval.End,
        })]),
        ["note"] = content.Note,
    };

    /// <summary>Long-term kernels go past the years that a calendar date can name; then it is the number of seconds.</summary>
    private static string Utc(double tdbSeconds, TimeScale scale)
    {
        try
        {
            return scale.InstantOf(tdbSeconds).ToIsoUtc();
        }
        catch (BadInputException)
        {
            return Invariant($"TDB {tdbSeconds:R}");
        }
    }
}
