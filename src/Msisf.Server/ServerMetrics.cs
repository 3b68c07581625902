using System.Collections.Concurrent;
using System.Diagnostics.Metrics;
using System.Text;
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

    /// <param name="time">From the request to the drawn frame.</param>
    public void FrameDrawn(TimeSpan time) => _frames.Record(time.TotalSeconds);

    /// <summary>Counts a stream that is opened or closed.</summary>
    /// <param name="change">1 or -1.</param>
    public void StreamsChanged(int change) => _streams.Add(change);

    /// <summary>The counts as Prometheus reads them.</summary>
    public string Text() => _text.ToString();

    public void Dispose()
    {
        _text.Dispose();
        _meter.Dispose();
    }

    private static IEnumerable<Measurement<double>> Collections() => Enumerable.Range(0, GC.MaxGeneration + 1).Select(
        generation => new Measurement<double>(GC.CollectionCount(generation), new KeyValuePair<string, object?>("generation", generation)));

    private void Gauge(string name, string help, Func<double> value) => _meter.CreateObservableGauge(name, value, null, help);
}

/// <summary>Keeps what the instruments of a meter measure, and writes it in the text form of Prometheus. Thread-safe.</summary>
internal sealed class PrometheusText : IDisposable
{
    public const string ContentType = "text/plain; version=0.0.4; charset=utf-8";

    private readonly MeterListener _listener = new();
    private readonly ConcurrentQueue<Instrument> _instruments = new();
    private readonly ConcurrentDictionary<(Instrument Instrument, string Labels), Series> _series = new();

    /// <param name="meter">The meter. Its instruments are named as Prometheus has them, measure doubles, and are made after this.</param>
    public PrometheusText(Meter meter)
    {
        _listener.InstrumentPublished = (instrument, listener) =>
        {
            if (instrument.Meter == meter)
            {
                _instruments.Enqueue(instrument);
                listener.EnableMeasurementEvents(instrument);
                if (instrument is Histogram<double> or UpDownCounter<double>)
                {
                    SeriesOf(instrument, string.Empty); // is 0 from the beginning
                }
            }
        };
        _listener.SetMeasurementEventCallback<double>((instrument, value, tags, _) => SeriesOf(instrument, Labels(tags)).Take(value));
        _listener.Start();
    }

    /// <summary>The text, its instruments in the order in which they were made.</summary>
    public override string ToString()
    {
        _listener.RecordObservableInstruments();
        ILookup<Instrument, (string Labels, Series Series)> all = _series.ToArray().ToLookup(
            pair => pair.Key.Instrument, pair => (pair.Key.Labels, pair.Value));
        StringBuilder text = new();
        foreach (Instrument instrument in _instruments)
        {
            text.Append(CultureInfo.InvariantCulture, $"# HELP {instrument.Name} {instrument.Description}\n");
            text.Append(CultureInfo.InvariantCulture, $"# TYPE {instrument.Name} {TypeOf(instrument)}\n");
            foreach ((string labels, Series series) in all[instrument].OrderBy(one => one.Labels, StringComparer.Ordinal))
            {
                series.Write(text, instrument.Name, labels);
            }
        }

        return text.ToString();
    }

    public void Dispose() => _listener.Dispose();

    private Series SeriesOf(Instrument instrument, string labels) => _series.GetOrAdd((instrument, labels), _ => new Series(
        isSum: instrument is Counter<double> or UpDownCounter<double> or Histogram<double>,
        (instrument as Histogram<double>)?.Advice?.HistogramBucketBoundaries));

    private static string TypeOf(Instrument instrument) => instrument switch
    {
        Histogram<double> => "histogram",
        Counter<double> or ObservableCounter<double> => "counter",
        _ => "gauge",
    };

    /// <summary>No label of this server has a quote or a backslash in it.</summary>
    private static string Labels(ReadOnlySpan<KeyValuePair<string, object?>> tags)
    {
        StringBuilder labels = new();
        foreach ((string name, object? value) in tags)
        {
            labels.Append(CultureInfo.InvariantCulture, $"{(labels.Length == 0 ? "{" : ",")}{name}=\"{value}\"");
        }

        return labels.Append(labels.Length == 0 ? "" : "}").ToString();
    }

    /// <summary>What was measured with the same labels.</summary>
    /// <param name="isSum">Whether values are added; if not, the last one counts.</param>
    /// <param name="borders">Upper borders of a histogram's classes; null of another instrument.</param>
    private sealed class Series(bool isSum, IReadOnlyList<double>? borders)
    {
        private readonly long[] _classes = new long[(borders?.Count ?? 0) + 1];
        private double _value;

        public void Take(double value)
        {
            int index = 0;
            while (index < _classes.Length - 1 && value > borders![index])
            {
                index++;
            }

            lock (_classes)
            {
                _classes[index]++;
                _value = isSum ? _value + value : value;
            }
        }

        public void Write(StringBuilder text, string name, string labels)
        {
            lock (_classes)
            {
                if (borders is null)
                {
                    text.Append(CultureInfo.InvariantCulture, $"{name}{labels} {_value:R}\n");
                    return;
                }

                long count = 0;
                for (int index = 0; index < _classes.Length; index++)
                {
                    count += _classes[index];
                    string border = index < borders.Count ? borders[index].ToString("R", CultureInfo.InvariantCulture) : "+Inf";
                    text.Append(CultureInfo.InvariantCulture, $"{name}_bucket{{le=\"{border}\"}} {count}\n");
                }

                text.Append(CultureInfo.InvariantCulture, $"{name}_sum {_value:R}\n{name}_count {count}\n");
            }
        }
    }
}
