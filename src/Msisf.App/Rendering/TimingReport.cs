using System.Diagnostics;
using System.Text;
using System.Text.Json;
using Msisf.App.Host;

namespace Msisf.App.Rendering;

/// <summary>Makes the report that <c>--timing</c> prints.</summary>
internal static class TimingReport
{
    /// <summary>All times as one line of JSON.</summary>
    /// <param name="times">Times of the parts of the run.</param>
    public static string Of(RunTimes times, IReadOnlyList<FrameOutputs> outputs)
    {
        double total = times.TotalSeconds;
        using MemoryStream stream = new();
        using (Utf8JsonWriter json = new(stream))
        {
            json.WriteStartObject();
            json.WriteNumber("frames", outputs.Count(frame => !frame.WasThere));
            json.WriteNumber("frames_there", outputs.Count(frame => frame.WasThere));
            json.WriteNumber("tiles", outputs.Sum(frame => (long)frame.TileCount));
            json.WriteNumber("patterns_made", outputs.Sum(frame => frame.PatternsMade));
            foreach (Phase phase in Enum.GetValues<Phase>())
            {
                json.WriteNumber(
                    $"{JsonNamingPolicy.SnakeCaseLower.ConvertName(phase.ToString())}_s", Math.Round(times.SecondsOf(phase), 4));
            }

            json.WriteNumber("other_s", Math.Round(times.OtherSeconds(total), 4));
            json.WriteNumber("total_s", Math.Round(total, 4));
            using Process process = Process.GetCurrentProcess();
            json.WriteNumber("peak_memory_bytes", process.PeakWorkingSet64);
            json.WriteEndObject();
        }

        return Encoding.UTF8.GetString(stream.ToArray());
    }
}
