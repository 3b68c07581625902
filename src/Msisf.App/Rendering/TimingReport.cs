using System.Diagnostics;
using System.Text;
using System.Text.Json;
using Msisf.App.Host;
using Msisf.App.Preparation;

namespace Msisf.App.Rendering;

/// <summary>Makes the report that <c>--timing</c> prints.</summary>
internal static class TimingReport
{
    /// <summary>All times as one line of JSON.</summary>
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

/// <summary>Writes the time of each frame to a file, one line per frame as soon as the frame is made. Thread-safe.</summary>
internal sealed class FrameTimes : IDisposable
{
    private readonly Lock _gate = new();
    private readonly StreamWriter? _file;
    private readonly string? _path;

    /// <summary>Creates the file.</summary>
    /// <param name="path">The file; null for none.</param>
    /// <exception cref="ExternalPartException">The file can't be written.</exception>
    public FrameTimes(string? path)
    {
        _path = path;
        _file = path is null ? null : Checked(() => new StreamWriter(path) { AutoFlush = true, NewLine = "\n" });
    }

    /// <summary>Writes the line of a frame.</summary>
    public void Add(Frame frame, TimeSpan time)
    {
        lock (_gate)
        {
            Checked(() =>
            {
                _file?.WriteLine(Invariant($"{frame.Step}\t{frame.Name}\t{time.TotalSeconds:F6}"));
                return true;
            });
        }
    }

    public void Dispose() => _file?.Dispose();

    private T Checked<T>(Func<T> work) => FileErrors.ToExternalPart($"--frame-times {_path}: can't be written", work);
}
