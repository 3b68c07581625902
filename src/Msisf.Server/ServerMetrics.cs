using System.Diagnostics.Metrics;
using Msisf.App.Serving;

namespace Msisf.Server;

/// <summary>Counts what the server did; other programs can follow the meter "Msisf.Server" as well. Thread-safe.</summary>
internal sealed class ServerMetrics : IDisposable
{
    /// <summary>s: upper borders of the classes of frame times.</summary>
    private static readonly InstrumentAdvice<double> Borders = new()
    {
        HistogramBucketBoundaries = [0.005, 0.01, 0.015, 0.02, 0.025, 0.03, 0.04, 0.06, 0.1, 0.25, 1.0, 10.0],
    };

    private readonly Meter _meter = new("Msisf.Server");
    private readonly PrometheusText _text;
    private readonly Counter<double> _requests;
    private readonly Histogram<double> _frames;
    private readonly UpDownCounter<double> _streams;

    /// <summary>Begins to count.</summary>
    /// <param name="queue">The work.</param>
    /// <param name="sessions">The warm sessions.</param>
    public ServerMetrics(RenderQueue queue, RenderSessions sessions, TimeProvider clock)
    {
        long start = clock.GetTimestamp();
        _text = new PrometheusText(_meter);
        _requests = _meter.CreateCounter<double>("msisf_requests_total", null, "Requests that were answered.");
        _frames = _meter.CreateHistogram(
            "msisf_frame_seconds", "s", "Time from the request to the drawn frame.", tags: null, advice: Borders);
        Gauge("msisf_waiting", "Requests that wait for their turn.", () => queue.Waiting);
        Gauge("msisf_running", "Requests whose work is done now.", () => queue.Running);
        _streams = _meter.CreateUpDownCounter<double>("msisf_streams", null, "Streams that are open.");
        Gauge("msisf_sessions", "Cameras with options that are kept warm.", () => sessions.Count);
        Gauge("process_resident_memory_bytes", "Memory of the program.", () => Environment.WorkingSet);
        _meter.CreateObservableCounter(
            "process_cpu_seconds_total", () => Environment.CpuUsage.TotalTime.TotalSeconds, "s", "Processor time of the program.");
        _meter.CreateObservableCounter(
            "dotnet_allocated_bytes_total", () => (double)GC.GetTotalAllocatedBytes(), null,
            "Memory that .NET has given to the program so far.");
        _meter.CreateObservableCounter(
            "dotnet_collections_total", Collections, null, "Garbage collections, of each generation with all below it.");
        Gauge("process_uptime_seconds", "Time since the server began.", () => clock.GetElapsedTime(start).TotalSeconds);
    }

    /// <summary>Counts a request that was answered.</summary>
    /// <param name="path">One of the server's own paths.</param>
    /// <param name="status">HTTP status.</param>
    public void Answered(string path, int status) => _requests.Add(1.0, new("path", path), new("status", status));

    /// <summary>Counts a frame.</summary>
    /// <param name="time">From the request to the drawn frame.</param>
    public void FrameDrawn(TimeSpan time) => _frames.Record(time.TotalSeconds);

    /// <summary>Counts a stream that is opened or closed.</summary>
    /// <param name="change">1 or -1.</param>
    public void StreamsChanged(int change) => _streams.Add(change);

    /// <summary>The counts as Prometheus reads them.</summary>
    public string Text() => _text.ToString();

    /// <summary>Ends the counting.</summary>
    public void Dispose()
    {
        _text.Dispose();
        _meter.Dispose();
    }

    private static IEnumerable<Measurement<double>> Collections() => Enumerable.Range(0, GC.MaxGeneration + 1).Select(
        generation => new Measurement<double>(GC.CollectionCount(generation), new KeyValuePair<string, object?>("generation", generation)));

    private void Gauge(string name, string help, Func<double> value) => _meter.CreateObservableGauge(name, value, null, help);
}
