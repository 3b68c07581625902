namespace Msisf.MySql;

/// <summary>
/// Caches the runs of samples that were read last. A run is a part of a line and is read once, even if several threads need it.
/// </summary>
internal sealed class RunCache
{
    /// <summary>
    /// Number of samples in a run: large enough that the fixed cost of a query is small, and that a tile at 512 px/deg needs at most two
    /// runs per line.
    /// </summary>
    private const int RunSamples = 8192;

    /// <summary>Maximum size of the cache, bytes: enough for a row of tiles at 64 px/deg.</summary>
    private const long Budget = 256L << 20;

    private readonly Lock _gate = new();
    private readonly Dictionary<(int Line, int First), Lazy<double[]>> _runs = [];
    private readonly Queue<(int Line, int First)> _order = new();
    private readonly int _lineSamples;
    private readonly Func<int, int, int, double[]> _read;

    /// <summary>Creates an empty cache.</summary>
    /// <param name="lineSamples">Number of samples per line.</param>
    /// <param name="read">Reads a run; receives line, first sample and count.</param>
    public RunCache(int lineSamples, Func<int, int, int, double[]> read)
    {
        _lineSamples = lineSamples;
        _read = read;
    }

    /// <summary>The samples from a given one to the end of its run, which are at least one.</summary>
    public ReadOnlySpan<double> From(int line, int sample)
    {
        int first = sample / RunSamples * RunSamples;
        Lazy<double[]> run;
        lock (_gate)
        {
            if (!_runs.TryGetValue((line, first), out run!))
            {
                int count = Math.Min(RunSamples, _lineSamples - first);
                run = new Lazy<double[]>(() => _read(line, first, count));
                _runs.Add((line, first), run);
                _order.Enqueue((line, first));
                while (_order.Count > Math.Max(Budget / (sizeof(double) * (long)RunSamples), 1))
                {
                    _runs.Remove(_order.Dequeue());
                }
            }
        }

        return run.Value.AsSpan(sample - first);
    }
}
