using System.Globalization;
using Msisf.TestSupport;

namespace Msisf.Stress.Cluster;

/// <summary>A run of the program with many frames, from an orbit.</summary>
/// <param name="Frames">How many.</param>
/// <param name="Size">Of the images, px by px.</param>
/// <param name="Patterns">POV-Ray's pattern repository, made when needed; null for the native renderer.</param>
internal sealed record FrameSeries(int Frames, int Size, string? Patterns = null)
{
    /// <summary>Days from frame to frame.</summary>
    private const decimal Step = 0.0001m;

    private const decimal Epoch = 55289;

    /// <summary>Arguments of the run that makes all frames.</summary>
    /// <param name="folder">Of the outputs.</param>
    /// <param name="more">Further arguments.</param>
    public IReadOnlyList<string> Arguments(string folder, params IEnumerable<string> more) =>
        [.. Settings, "--output-dir", folder, "--batch", .. more];

    /// <summary>What says which frames these are and what they look like.</summary>
    public IReadOnlyList<string> Settings =>
    [
        "--kepler-set", "{1.9E6,0.05,0.7,1.1,0.9,2.0}", "--epoch", Text(Epoch), "--time-interval",
        $"[{Text(Epoch)}:{Text(Step)}:{Text(Epoch + (Step * (Frames - 1)))}]",
        "--width", Text(Size), "--height", Text(Size), "--ldem", TestParts.Ldem4Label!, "--ephemeris", "builtin",
        .. Patterns is null ? (string[])["--renderer", "native", "--reflectance", "lambert"] : ["--renderer", "povray",
        "--pattern-repos", Patterns],
    ];

    private static string Text(decimal number) => number.ToString(CultureInfo.InvariantCulture);
}
