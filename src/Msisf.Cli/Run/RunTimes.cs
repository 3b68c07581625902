using System.Diagnostics;
using System.Text;
using System.Text.Json;

namespace Msisf.Cli.Run;

/// <summary>Where a run's time went, in s, summed over its frames; frames that run side by side add up. Safe for several threads.</summary>
internal sealed class RunTimes
{
    private readonly Lock _gate = new();
    private readonly double[] _seconds = new double[Enum.GetValues<Phase>().Length];
    private readonly long _start = Stopwatch.GetTimestamp();

    public RunTimes(TimeProvider clock)
    {
        using Process process = Process.GetCurrentProcess();
        double sinceStart = (clock.GetUtcNow().UtcDateTime - process.StartTime.ToUniversalTime()).TotalSeconds;
        Add(Phase.StartUp, Math.Max(0.0, sinceStart));
    }

    public void Add(Phase phase, double seconds)
    {
        lock (_gate)
        {
            _seconds[(int)phase] += seconds;
        }
    }

    public T Measure<T>(Phase phase, Func<T> work)
    {
        long start = Stopwatch.GetTimestamp();
        try
        {
            return work();
        }
        finally
        {
            Add(phase, Stopwatch.GetElapsedTime(start).TotalSeconds);
        }
    }

    public void Measure(Phase phase, Action work) => Measure(phase, () =>
    {
        work();
        return true;
    });

    /// <summary>All times as one line of JSON.</summary>
    /// <param name="outputs">Of all frames.</param>
    public string ToJson(IReadOnlyList<FrameOutputs> outputs)
    {
        using MemoryStream stream = new();
        using (Utf8JsonWriter json = new(stream))
        {
            json.WriteStartObject();
            json.WriteNumber("frames", outputs.Count(frame => !frame.WasThere));
            json.WriteNumber("frames_there", outputs.Count(frame => frame.WasThere));
            json.WriteNumber("tiles", outputs.Sum(frame => (long)frame.TileCount));
            json.WriteNumber("patterns_made", outputs.Sum(frame => frame.PatternsMade));
            lock (_gate)
            {
                foreach (Phase phase in Enum.GetValues<Phase>())
                {
                    json.WriteNumber($"{JsonNamingPolicy.SnakeCaseLower.ConvertName(phase.ToString())}_s", Rounded(_seconds[(int)phase]));
                }

                json.WriteNumber("total_s", Rounded(_seconds[(int)Phase.StartUp] + Stopwatch.GetElapsedTime(_start).TotalSeconds));
            }

            using Process process = Process.GetCurrentProcess();
            json.WriteNumber("peak_memory_bytes", process.PeakWorkingSet64);
            json.WriteEndObject();
        }

        return Encoding.UTF8.GetString(stream.ToArray());
    }

    private static double Rounded(double seconds) => Math.Round(seconds, 4);
}
