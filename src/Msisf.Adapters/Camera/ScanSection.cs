using Msisf.Adapters.Input;
using Msisf.Core.Camera;

namespace Msisf.Adapters.Camera;

/// <summary>How the camera of a file scans, but for the number of its exposures.</summary>
/// <param name="Kind">What an exposure adds to the image.</param>
/// <param name="Period">s; null if the user is to say it.</param>
public sealed record CameraFileScan(ScanKind Kind, double? Period)
{
    /// <inheritdoc cref="Scan.Stages"/>
    public int Stages { get; init; } = 1;

    /// <inheritdoc cref="Scan.ChargeMovesDown"/>
    public bool ChargeMovesDown { get; init; } = true;

    /// <inheritdoc cref="Scan.Framelet"/>
    public PixelRows? Framelet { get; init; }

    /// <inheritdoc cref="Scan.GrowsUpwards"/>
    public bool GrowsUpwards { get; init; }

    /// <inheritdoc cref="Scan.FlipsFramelets"/>
    public bool FlipsFramelets { get; init; }
}

/// <summary>Reads the section "scan" of a camera file (docs/scanning-cameras.md).</summary>
internal static class ScanSection
{
    private const string Name = "scan";

    private static readonly string[] Keys = ["kind", "period", "tdi", "tdi-direction", "framelet", "order", "flip"];

    private static readonly (string Word, ScanKind Kind)[] Kinds =
        [("line-scan", ScanKind.LineScan), ("push-frame", ScanKind.PushFrame), ("rolling-shutter", ScanKind.RollingShutter)];

    /// <summary>Reads the section.</summary>
    /// <param name="file">The top level of the file.</param>
    /// <param name="height">px: rows of the camera.</param>
    /// <param name="detector">What the file says of the detector; null for nothing.</param>
    /// <returns>Null if there is no section.</returns>
    /// <exception cref="Core.Errors.BadInputException">What is wrong in it, by file, line and column.</exception>
    public static CameraFileScan? Read(SettingsSection file, int height, CameraFileDetector? detector)
    {
        if (file.Section(Name, "a scan", Keys) is not { } section)
        {
            return null;
        }

        string word = section.Word("kind", [.. Kinds.Select(kind => kind.Word)])
            ?? throw section.Missing("kind", "what an exposure adds to the image: line-scan, push-frame or rolling-shutter");
        ScanKind kind = Kinds.First(known => known.Word == word).Kind;
        RefuseOthers(section, kind, word);
        if (kind == ScanKind.RollingShutter && !section.Has("period"))
        {
            throw section.Missing("period", "s from the exposure of a row to that of the row below");
        }

        if (detector?.Settings.Shutter is { IsRolling: true })
        {
            throw section.Wrong(
                "kind", "'scan' and the detector's rolling 'shutter' both say when rows are exposed. Make the shutter global, or leave "
                    + "it out");
        }

        return new CameraFileScan(kind, section.Positive("period"))
        {
            Stages = kind == ScanKind.LineScan ? Stages(section, file, height, detector is not null) : 1,
            ChargeMovesDown = section.Word("tdi-direction", ["down", "up"]) != "up",
            Framelet = section.Numbers("framelet", 2, 2) is { } rows ? Framelet(section, rows, height) : null,
            GrowsUpwards = section.Word("order", ["down", "up"]) == "up",
            FlipsFramelets = section.Word("flip", ["yes", "no", "true", "false"]) is "yes" or "true",
        };
    }

    private static void RefuseOthers(SettingsSection section, ScanKind kind, string word)
    {
        string[] allowed = kind switch
        {
            ScanKind.LineScan => ["tdi", "tdi-direction", "order"],
            ScanKind.PushFrame => ["framelet", "order", "flip"],
            _ => [],
        };
        if (Keys[2..].FirstOrDefault(key => section.Has(key) && !allowed.Contains(key)) is { } wrong)
        {
            throw section.Wrong(wrong, $"'{wrong}' has no meaning for kind {word}. Leave it out");
        }

        DetectorSection.RequireWith(section, "tdi-direction", "tdi");
    }

    private static int Stages(SettingsSection section, SettingsSection file, int height, bool hasDetector)
    {
        int stages = section.Whole("tdi", 1, CameraFileReader.MaxSide) ?? 1;
        if (stages != height)
        {
            throw file.Wrong("height", stages == 1
                ? $"'height' is {height}, and a line-scan camera has one row. Make it 1, or give 'tdi' of section 'scan' as many rows"
                : $"'height' is {height}, and 'tdi' adds the electrons of {stages} rows. Make them equal");
        }

        return stages == 1 || hasDetector
            ? stages
            : throw section.Wrong("tdi", "'tdi' adds electrons and needs the section 'detector'. Add it, or leave 'tdi' out");
    }

    private static PixelRows Framelet(SettingsSection section, double[] rows, int height)
    {
        (double first, double count) = (rows[0], rows[1]);
        return first >= 1.0 && count >= 1.0 && first == Math.Floor(first) && count == Math.Floor(count) && first + count - 1.0 <= height
            ? new PixelRows((int)first - 1, (int)(first + count - 1.0))
            : throw section.Wrong("framelet", Invariant(
                $"'framelet' is {count} rows from row {first} on, and the detector has rows 1 to {height}. Two whole numbers are needed: ")
                    + "the first row and how many");
    }
}
