using System.Text.RegularExpressions;
using Msisf.Core.Camera;

namespace Msisf.Adapters.Render;

/// <summary>One run of POV-Ray.</summary>
/// <param name="Scene">Writes the scene.</param>
/// <param name="PatternFolder">Folder of the patterns that the scene includes by file name.</param>
/// <param name="WorkFolder">An existing folder on the disk of the outputs, for POV-Ray's own files.</param>
/// <param name="Width">Image width, px.</param>
/// <param name="Height">Image height, px.</param>
/// <param name="Rows">The rows to draw, the others stay black; null for all.</param>
/// <param name="Threads">Threads that POV-Ray may use.</param>
/// <param name="Options">POV-Ray options after the usual ones, which they overrule.</param>
/// <param name="Timeout">Longest allowed run, or null for no limit.</param>
public sealed record PovRayJob(
    Action<TextWriter> Scene,
    string PatternFolder,
    string WorkFolder,
    int Width,
    int Height,
    PixelRows? Rows,
    int Threads,
    IReadOnlyList<string> Options,
    TimeSpan? Timeout);

/// <summary>What a run of POV-Ray gave.</summary>
/// <param name="Raster">The image.</param>
/// <param name="Times">POV-Ray's own times.</param>
public sealed record PovRayImage(PngRaster Raster, PovRayTimes Times);

/// <summary>The times that POV-Ray reports, s; null where it reports none.</summary>
/// <param name="ParseSeconds">Reading the scene and its patterns.</param>
/// <param name="TraceSeconds">Tracing.</param>
public readonly partial record struct PovRayTimes(double? ParseSeconds, double? TraceSeconds)
{
    /// <summary>Reads the times from what POV-Ray printed.</summary>
    /// <param name="output">Its statistics, e.g. "Parse Time:  0 hours  0 minutes  1 seconds (1.234 seconds)".</param>
    public static PovRayTimes Read(string output) => new(Seconds(output, "Parse"), Seconds(output, "Trace"));

    private static double? Seconds(string output, string phase)
    {
        Match match = TimeLine().Matches(output).LastOrDefault(candidate => candidate.Groups["phase"].Value == phase) ?? Match.Empty;
        return match.Success ? double.Parse(match.Groups["seconds"].Value, CultureInfo.InvariantCulture) : null;
    }

    [GeneratedRegex(@"(?<phase>Parse|Trace) Time:[^(]*\((?<seconds>[0-9.]+) seconds\)")]
    private static partial Regex TimeLine();
}
