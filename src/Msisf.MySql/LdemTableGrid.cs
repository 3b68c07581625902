using Msisf.Core.Terrain;

namespace Msisf.MySql;

/// <summary>
/// An elevation model in a table that scripts/ldem_mysql_insert.php has filled (docs/database.md). Samples are read in blocks of a line and
/// cached, because neighbouring tiles share them. Thread-safe.
/// </summary>
public sealed class LdemTableGrid : IGlobalGrid
{
    private readonly Database _database;
    private readonly string _table;
    private readonly RunCache _runs;

    private LdemTableGrid(Database database, int pixelsPerDegree, string table, string productId)
    {
        _database = database;
        _table = table;
        ProductId = productId;
        PixelsPerDegree = pixelsPerDegree;
        _runs = new RunCache(LineSamples, ReadRun);
    }

    /// <inheritdoc/>
    public string ProductId { get; }

    /// <inheritdoc/>
    public int PixelsPerDegree { get; }

    private int LineSamples => 360 * PixelsPerDegree;

    /// <summary>Opens the model of a resolution.</summary>
    /// <param name="database">Database of the tables; the caller disposes of it after this object.</param>
    /// <param name="pixelsPerDegree">Resolution, px/deg, at least 1.</param>
    /// <exception cref="BadInputException">The model was not imported, or only in part.</exception>
    /// <exception cref="ExternalPartException">The database can't be reached, or rejects the query.</exception>
    public static LdemTableGrid Open(Database database, int pixelsPerDegree)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(pixelsPerDegree, 1);
        string table = Invariant($"ldem_{pixelsPerDegree}");
        string productId = ImportedModel.ReadProductId(database, table);
        return new LdemTableGrid(database, pixelsPerDegree, table, productId);
    }

    /// <inheritdoc/>
    /// <exception cref="ExternalPartException">The database failed.</exception>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(line);
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(line, 180 * PixelsPerDegree);
        ArgumentOutOfRangeException.ThrowIfNegative(firstSample);
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(firstSample, LineSamples);
        ArgumentOutOfRangeException.ThrowIfLessThan(radii.Length, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(radii.Length, LineSamples);
        int sample = firstSample;
        while (!radii.IsEmpty)
        {
            ReadOnlySpan<double> found = _runs.From(line, sample);
            int taken = Math.Min(found.Length, radii.Length);
            found[..taken].CopyTo(radii);
            radii = radii[taken..];
            sample = (sample + taken) % LineSamples;
        }
    }

    private double[] ReadRun(int line, int firstSample, int count) => _database.Query(
        $"SELECT planetary_radius FROM {_table} WHERE row_index = @row AND col_index BETWEEN @first AND @last ORDER BY col_index",
        [("@row", line), ("@first", firstSample), ("@last", firstSample + count - 1)],
        reader =>
        {
            double[] radii = new double[count];
            int found = 0;
            while (reader.Read() && found < count)
            {
                radii[found++] = reader.GetDouble(0);
            }

            // The primary key is (row, column), so a complete count means that every sample was found.
            return found == count ? radii : throw new BadInputException(Invariant(
                $"table {_table}: only {found} of {count} samples of line {line + 1} from sample {firstSample + 1} on are there. "
                    + $"Import the product that has them, or run scripts/ldem_mysql_insert.php --verify."));
        });
}

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
