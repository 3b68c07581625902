using System.Collections.Concurrent;
using System.Diagnostics;
using System.Globalization;
using System.Text;
using Msisf.App.Serving;

namespace Msisf.Server;

/// <summary>Counts what the server did, in the text form of Prometheus. Thread-safe.</summary>
/// <param name="queue">The work.</param>
/// <param name="sessions">The warm sessions.</param>
/// <param name="clock">Clock.</param>
internal sealed class ServerMetrics(RenderQueue queue, RenderSessions sessions, TimeProvider clock)
{
    /// <summary>Content type of the text.</summary>
    public const string ContentType = "text/plain; version=0.0.4; charset=utf-8";

    /// <summary>s: upper borders of the classes of frame times.</summary>
    private static readonly double[] Borders = [0.005, 0.01, 0.015, 0.02, 0.025, 0.03, 0.04, 0.06, 0.1, 0.25, 1.0, 10.0];

    private readonly ConcurrentDictionary<(string Path, int Status), long> _requests = new();
    private readonly long[] _frames = new long[Borders.Length + 1];
    private readonly long _start = clock.GetTimestamp();
    private double _seconds;
    private int _streams;

    /// <summary>Counts a request that was answered.</summary>
    /// <param name="path">One of the server's own paths.</param>
    /// <param name="status">HTTP status.</param>
    public void Answered(string path, int status) => _requests.AddOrUpdate((path, status), 1, (_, count) => count + 1);

    /// <summary>Counts a frame.</summary>
    /// <param name="time">From the request to the drawn frame.</param>
    public void FrameDrawn(TimeSpan time)
    {
        int index = Array.FindIndex(Borders, border => time.TotalSeconds <= border);
        lock (_frames)
        {
            _frames[index < 0 ? Borders.Length : index]++;
            _seconds += time.TotalSeconds;
        }
    }

    /// <summary>Counts a stream that is opened or closed.</summary>
    /// <param name="change">1 or -1.</param>
    public void StreamsChanged(int change) => Interlocked.Add(ref _streams, change);

    /// <summary>The counts as text.</summary>
    public string Text()
    {
        StringBuilder text = new();
        Head(text, "msisf_requests_total", "counter", "Requests that were answered.");
        foreach (((string path, int status), long count) in _requests.ToArray().OrderBy(pair => pair.Key))
        {
            text.Append(CultureInfo.InvariantCulture, $"msisf_requests_total{{path=\"{path}\",status=\"{status}\"}} {count}\n");
        }

        Head(text, "msisf_frame_seconds", "histogram", "Time from the request to the drawn frame.");
        lock (_frames)
        {
            long sum = 0;
            for (int index = 0; index < _frames.Length; index++)
            {
                sum += _frames[index];
                string border = index < Borders.Length ? Borders[index].ToString("R", CultureInfo.InvariantCulture) : "+Inf";
                text.Append(CultureInfo.InvariantCulture, $"msisf_frame_seconds_bucket{{le=\"{border}\"}} {sum}\n");
            }

            text.Append(CultureInfo.InvariantCulture, $"msisf_frame_seconds_sum {_seconds:R}\nmsisf_frame_seconds_count {sum}\n");
        }

        Gauge(text, "msisf_waiting", "Requests that wait for their turn.", queue.Waiting);
        Gauge(text, "msisf_running", "Requests whose work is done now.", queue.Running);
        Gauge(text, "msisf_streams", "Streams that are open.", Volatile.Read(ref _streams));
        Gauge(text, "msisf_sessions", "Cameras with options that are kept warm.", sessions.Count);
        using Process process = Process.GetCurrentProcess();
        Gauge(text, "process_resident_memory_bytes", "Memory of the program.", process.WorkingSet64);
        Head(text, "process_cpu_seconds_total", "counter", "Processor time of the program.");
        text.Append(CultureInfo.InvariantCulture, $"process_cpu_seconds_total {process.TotalProcessorTime.TotalSeconds:R}\n");
        Head(text, "dotnet_allocated_bytes_total", "counter", "Memory that .NET has given to the program so far.");
        text.Append(CultureInfo.InvariantCulture, $"dotnet_allocated_bytes_total {GC.GetTotalAllocatedBytes()}\n");
        Head(text, "dotnet_collections_total", "counter", "Garbage collections, of each generation with all below it.");
        for (int generation = 0; generation <= GC.MaxGeneration; generation++)
        {
            int count = GC.CollectionCount(generation);
            text.Append(CultureInfo.InvariantCulture, $"dotnet_collections_total{{generation=\"{generation}\"}} {count}\n");
        }

        Gauge(text, "process_uptime_seconds", "Time since the server began.", clock.GetElapsedTime(_start).TotalSeconds);
        return text.ToString();
    }

    private static void Gauge(StringBuilder text, string name, string help, double value)
    {
        Head(text, name, "gauge", help);
        text.Append(CultureInfo.InvariantCulture, $"{name} {value:R}\n");
    }

    private static void Head(StringBuilder text, string name, string type, string help) =>
        text.Append(CultureInfo.InvariantCulture, $"# HELP {name} {help}\n# TYPE {name} {type}\n");
}
