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
        CheckBlock(line, 1, firstSample, radii.Length);
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

    private void CheckBlock(int firstLine, int lines, int firstSample, int samples)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(firstLine);
        ArgumentOutOfRangeException.ThrowIfLessThan(lines, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan((long)firstLine + lines, 180 * PixelsPerDegree, nameof(lines));
        ArgumentOutOfRangeException.ThrowIfNegative(firstSample);
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(firstSample, LineSamples);
        ArgumentOutOfRangeException.ThrowIfLessThan(samples, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(samples, LineSamples);
    }
}
