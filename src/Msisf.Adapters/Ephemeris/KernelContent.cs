using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Adapters.Ephemeris;

/// <summary>What one segment of a kernel holds, or a text kernel.</summary>
/// <param name="File">The file's name without folders.</param>
/// <param name="Kind">SPK, CK, PCK; FK, IK, SCLK, LSK, ... of a text kernel.</param>
/// <param name="ByteOrder">"little" or "big"; null of a text kernel.</param>
/// <param name="Body">NAIF's number of the body or instrument; null of a text kernel.</param>
/// <param name="Name">The name of that; null where no list has it.</param>
/// <param name="RelativeTo">The centre of positions, or the frame of attitudes.</param>
/// <param name="Frame">The frame of positions; null of others.</param>
/// <param name="Type">SPICE's data type; null of a text kernel.</param>
/// <param name="Cover">When there are data, in TDB; null where a clock is missing, and of a text kernel.</param>
/// <param name="Note">What a text kernel defines, or what is missing; null for nothing to say.</param>
public sealed record KernelContent(
    string File, string Kind, string? ByteOrder, int? Body, string? Name, string? RelativeTo, string? Frame, int? Type, TdbCover? Cover,
    string? Note)
{
    /// <summary>Lists kernels.</summary>
    /// <param name="paths">Kernels (no meta-kernels), in load order.</param>
    /// <param name="installed">The kernels of the installation, whose leap seconds give the times.</param>
    /// <returns>The contents of each file in turn, and the scale that turns their times into UTC.</returns>
    /// <exception cref="BadInputException">A kernel can't be read, or is damaged.</exception>
    public static (IReadOnlyList<KernelContent> Contents, TimeScale Scale) Of(
        IReadOnlyList<string> paths, IReadOnlyList<string> installed)
    {
        using KernelCatalogue catalogue = new([.. installed.Where(path => KernelFile.IdWordOf(path) == "KPL/LSK"), .. paths]);
        TimeScale scale = LeapSecondsKernel.ReadScale(catalogue.Pool);
        Dictionary<string, DafFile> binary = catalogue.Files.DistinctBy(file => file.FileName).ToDictionary(file => file.FileName);
        return (
            [
                .. paths.SelectMany(path => binary.TryGetValue(path, out DafFile? file)
                    ? file.Summaries.Select(summary => OfSegment(file, summary, catalogue))
                    : [OfText(path)]),
            ],
            scale);
    }

    private static KernelContent OfSegment(DafFile file, DafSummary summary, KernelCatalogue catalogue)
    {
        (string kind, int? frame, int type) = file.IdWord switch
        {
            "DAF/SPK" => ("SPK", (int?)summary.Integers[2], summary.Integers[3]),
            "DAF/CK" => ("CK", null, summary.Integers[2]),
            _ => ("PCK", null, summary.Integers[2]),
        };
        int body = summary.Integers[0];
        string relative = kind == "SPK"
            ? catalogue.Names.Describe(summary.Integers[1])
            : catalogue.Frames.Describe(summary.Integers[1]);
        (TdbCover? cover, string? note) = kind == "CK"
            ? CoverOfCk(file, summary, catalogue.Attitudes)
            : (TdbCover.Union([summary.Interval]), null);
        return new KernelContent(
            Path.GetFileName(file.FileName), kind, file.IsLittleEndian ? "little" : "big", body, catalogue.Names.NameOf(body), relative,
            frame is { } number ? catalogue.Frames.Describe(number) : null, type, cover, note);
    }

    private static (TdbCover? Cover, string? Note) CoverOfCk(DafFile file, DafSummary summary, SpacecraftAttitudes attitudes)
    {
        CkSegment segment = DafSegments.OfCk(file, summary);
        return attitudes.HasClockOf(segment.Instrument)
            ? (attitudes.CoverOf(segment), null)
            : (null, Invariant(
                $"ticks {summary.Interval.Start:R} to {summary.Interval.End:R}: the clock of spacecraft "
                    + $"{attitudes.NumberOfClock(segment.Instrument)} (SCLK) is missing"));
    }

    private static KernelContent OfText(string path)
    {
        string idWord = KernelFile.IdWordOf(path);
        if (KernelFile.IsBinary(path))
        {
            return new KernelContent(Path.GetFileName(path), idWord, null, null, null, null, null, null, null, "not used for images");
        }

        KernelPool pool = KernelPool.Of([path]);
        string kind = idWord.StartsWith("KPL/", StringComparison.Ordinal) ? idWord[4..] : "text";
        string note = kind switch
        {
            "FK" or "SCLK" or "LSK" or "IK" or "PCK" => string.Empty,
            _ => "kind unknown; ",
        };
        int frames = pool.Names.Count(
            name => name.StartsWith("FRAME_", StringComparison.Ordinal) && name.EndsWith("_NAME", StringComparison.Ordinal));
        int clocks = pool.Names.Count(name => name.StartsWith("SCLK_DATA_TYPE_", StringComparison.Ordinal));
        int instruments = pool.Names.Where(name => name.StartsWith("INS-", StringComparison.Ordinal))
            .Select(name => name.Split('_')[0]).Distinct().Count();
        string[] parts =
        [
            Invariant($"{pool.Names.Count} variables"),
            .. Counted(frames, "frame"), .. Counted(instruments, "instrument"), .. Counted(clocks, "clock"),
        ];
        return new KernelContent(
            Path.GetFileName(path), kind, null, null, null, null, null, null, null, note + string.Join(", ", parts));
    }

    private static string[] Counted(int count, string what) => count == 0
        ? []
        : [Invariant($"{count} {what}{(count == 1 ? string.Empty : "s")}")];
}
