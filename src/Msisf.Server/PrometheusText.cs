using System.Collections.Concurrent;
using System.Diagnostics.Metrics;
using System.Text;

namespace Msisf.Server;

/// <summary>Keeps what the instruments of a meter measure, and writes it in the text form of Prometheus. Thread-safe.</summary>
internal sealed class PrometheusText : IDisposable
{
    public const string ContentType = "text/plain; version=0.0.4; charset=utf-8";

    private readonly MeterListener _listener = new();
    private readonly ConcurrentQueue<Instrument> _instruments = new();
    private readonly ConcurrentDictionary<(Instrument Instrument, string Labels), Series> _series = new();

    /// <summary>Listens to a meter.</summary>
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

    /// <summary>Ends the listening.</summary>
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
