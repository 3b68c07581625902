using System.Globalization;
using System.Text.RegularExpressions;

namespace Msisf.Adapters.Render;

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
