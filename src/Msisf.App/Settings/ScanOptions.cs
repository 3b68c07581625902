using System.Security.Cryptography;
using Msisf.Adapters.Camera;
using Msisf.Adapters.Input;
using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Metadata;
using Msisf.Core.Scene;

namespace Msisf.App.Settings;

/// <summary>The options of cameras that scan.</summary>
internal static class ScanOptions
{
    /// <summary>Lines: each has a state of its own and is written when it is drawn, so there is no limit of memory.</summary>
    private const int MaxExposures = 10_000_000;

    public static WholeNumberSpec Lines { get; } = new(
        "--lines",
        DecidesBytes.UnlessDefault(frame => frame.Settings.Scan is { Kind: ScanKind.LineScan } scan ? scan.Count : null),
        "N", 1, MaxExposures, "Lines of the image, for a camera file whose section 'scan' is a line-scan: each has its own time and state");

    public static WholeNumberSpec Framelets { get; } = new(
        "--framelets",
        DecidesBytes.UnlessDefault(frame => frame.Settings.Scan is { Kind: ScanKind.PushFrame } scan ? scan.Count : null),
        "N", 1, MaxExposures, "Framelets of the image, for a camera file whose section 'scan' is a push-frame");

    public static NumberSpec Period { get; } = new(
        "--scan-period", DecidesBytes.UnlessDefault(frame => frame.Settings.GivenScanPeriod), "SECONDS",
        "Time from line to line, or from framelet to framelet, in place of the camera file's 'period'")
    {
        Limits = new NumberRange(0.0, 1e6) { ExcludesMin = true },
    };

    public static PathSpec Jitter { get; } = new(
        "--jitter", DecidesBytes.UnlessDefault(frame => frame.Settings.Jitter?.Text).OfRuns(), PathKind.File,
        "Small turns of the camera while it takes images: seconds, roll, pitch and yaw (microradians) a line, or sines");

    public static PathSpec Trajectory { get; } = new(
        "--trajectory", DecidesBytes.ByStatesOfRun, PathKind.File,
        "States as in --batch-file that are samples of one motion; images are taken between them, at --time, or from the first one on. A "
            + "file that --oem reads does as well");

    public static ChoiceSpec<InterpolationMethod> Positions { get; } = new(
        "--trajectory-positions", DecidesBytes.ByStates,
        [("lagrange", InterpolationMethod.Lagrange), ("hermite", InterpolationMethod.Hermite), ("linear", InterpolationMethod.Linear)],
        "With --trajectory: positions by a polynomial of degree 7 through eight samples, through four and their velocities, or by straight "
            + "lines")
    {
        DefaultNote = "hermite where the file has velocities, otherwise lagrange",
    };

    public static ChoiceSpec<AttitudePath> Attitudes { get; } = new(
        "--trajectory-attitudes", DecidesBytes.ByStates,
        [("slerp", AttitudePath.Slerp), ("squad", AttitudePath.Squad), ("hermite", AttitudePath.Hermite)],
        "With --trajectory: attitudes by turns at a constant rate from sample to sample, by squad, whose rate does not jump, or by cubic "
            + "polynomials with the samples' angular velocities")
    {
        DefaultNote = "hermite where the file has angular velocities, otherwise slerp",
    };

    /// <summary>The options that say how an image is scanned.</summary>
    public static OptionSpec[] OfImage { get; } = [Lines, Framelets, Period, Jitter];

    public static OptionSpec[] OfTrajectory { get; } = [Trajectory, Positions, Attitudes];

    /// <summary>Reads how an image is scanned; null for a frame.</summary>
    /// <param name="camera">The camera file; null for none.</param>
    /// <exception cref="UsageException">The camera does not scan so.</exception>
    public static Scan? Read(CameraFile? camera, OptionValues values)
    {
        (int? lines, int? framelets, double? period) =
            (Lines.ReadIfGiven(values), Framelets.ReadIfGiven(values), Period.ReadIfGiven(values));
        OptionSpec[] given = [.. lines is null ? [] : (OptionSpec[])[Lines], .. framelets is null ? [] : (OptionSpec[])[Framelets]];
        if (camera?.Scan is not { } scan)
        {
            return (given.FirstOrDefault() ?? (period is null ? null : Period)) is { } wrong
                ? throw wrong.Wrong(
                    $"needs a camera that scans: one whose file has the section 'scan'. Give it by {ImageOptions.Camera.Name}, or leave "
                        + $"{wrong.Name} out.", ImageOptions.Camera)
                : null;
        }

        OptionSpec? own = scan.Kind switch
        {
            ScanKind.LineScan => Lines,
            ScanKind.PushFrame => Framelets,
            _ => null,
        };
        if (given.FirstOrDefault(option => option != own) is { } other)
        {
            string advice = own is null ? ", whose rows are its height. Leave it out."
                : given.Length > 1 ? ". Leave it out."
                : $". Give {own.Name}.";
            throw other.Wrong($"has no meaning for --camera {camera.Name}{advice}", ImageOptions.Camera);
        }

        if (own is not null && given.Length == 0)
        {
            return period is null
                ? null
                : throw Period.Wrong($"needs {own.Name}: how many. Add it.");
        }

        return new Scan(
            scan.Kind,
            lines ?? framelets ?? camera.Model.Height,
            period ?? scan.Period ?? throw new UsageException($"--camera {camera.Name} has no 'period' in its section 'scan'. Give "
                + $"{Period.Name}: the seconds from one {(scan.Kind == ScanKind.LineScan ? "line" : "framelet")} to the "
                + "next.").About(Period))
        {
            Stages = scan.Stages,
            ChargeMovesDown = scan.ChargeMovesDown,
            Framelet = scan.Framelet,
            GrowsUpwards = scan.GrowsUpwards,
            FlipsFramelets = scan.FlipsFramelets,
        };
    }

    public static JitterFile? ReadJitter(OptionValues values) => Jitter.ReadIfGiven(values) is not { } path ? null
        : Directory.Exists(path) ? throw new BadInputException($"{Jitter.Name} {path}: is a folder; a file of jitter is needed.")
        : !File.Exists(path) ? throw new BadInputException($"{Jitter.Name} {path}: there is no such file.")
        : FileErrors.ToBadInput($"{Jitter.Name} {path}: can't be read", () => JitterFile.Of(path, File.ReadAllBytes(path)));
}

/// <summary>A file of jitter.</summary>
/// <param name="Path">Where it is.</param>
/// <param name="Sha256">Its checksum, hexadecimal.</param>
/// <param name="Jitter">Its content.</param>
/// <param name="Bytes">Its length.</param>
internal sealed record JitterFile(string Path, string Sha256, Jitter Jitter, long Bytes)
{
    /// <param name="path">For messages.</param>
    /// <exception cref="BadInputException">What is wrong in it.</exception>
    public static JitterFile Of(string path, byte[] content)
    {
        using StreamReader reader = new(new MemoryStream(content));
        string checksum = Convert.ToHexStringLower(SHA256.HashData(content));
        return new JitterFile(path, checksum, JitterFileReader.Read(reader, path), content.Length);
    }

    /// <summary>Name and the beginning of the checksum, as the arguments of a frame have it.</summary>
    public string Text => $"{System.IO.Path.GetFileName(Path)}#{Sha256[..16]}";

    /// <summary>The file as one of those that a frame is made from.</summary>
    public InputFile ToInput() => new(InputKind.Jitter, System.IO.Path.GetFileName(Path), Bytes, Sha256);
}

/// <summary>Which scanned images are drawn strip by strip, because they are too large for the memory.</summary>
internal static class StripRules
{
    /// <summary>px: larger images are drawn in strips; one of so many takes some 1.6 GB.</summary>
    public const long LargestWhole = 1L << 23;

    /// <summary>px of a strip: 50 MB.</summary>
    public const long PixelsOfStrip = 1L << 18;

    /// <summary>Whether an image is drawn in strips.</summary>
    /// <param name="scan">How it is scanned; null for a frame.</param>
    /// <param name="width">px.</param>
    /// <param name="height">px.</param>
    public static bool IsStriped(Scan? scan, int width, int height) =>
        scan is { Kind: not ScanKind.RollingShutter } && (long)width * height > LargestWhole;
}
