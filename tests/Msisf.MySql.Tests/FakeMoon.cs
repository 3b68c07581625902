using System.Data;
using System.Globalization;
using Msisf.Core.Terrain;
using MySqlConnector;

namespace Msisf.MySql.Tests;

/// <summary>The tables of docs/database.md with a grid in them; counts the questions for samples.</summary>
internal sealed class FakeMoon
{
    private readonly IGlobalGrid _grid;
    private readonly List<object[]> _records;
    private int _sampleQueries;

    public FakeMoon(IGlobalGrid grid, params object[][] records)
    {
        _grid = grid;
        _records = [.. records];
        Source = new FakeDataSource(Answer);
        Database = new Database(Source, "fake", CancellationToken.None);
    }

    public FakeDataSource Source { get; }

    public Database Database { get; }

    public int SampleQueries => _sampleQueries;

    /// <summary>Column of a sample that is not in the table, in every line.</summary>
    public int? MissingColumn { get; init; }

    /// <summary>A row of ldem_import: product, state, format, lines done, lines.</summary>
    public static object[] Record(string product, string state = "complete", ushort format = 1, uint done = 360, uint all = 360) =>
        [product, state, format, done, all];

    public DataTable Answer(string text, IReadOnlyDictionary<string, object> parameters)
    {
        string table = string.Create(CultureInfo.InvariantCulture, $"ldem_{_grid.PixelsPerDegree}");
        if (text.Contains("FROM ldem_import", StringComparison.Ordinal))
        {
            return Equals(parameters["@table"], table)
                ? Table([typeof(string), typeof(string), typeof(ushort), typeof(uint), typeof(uint)], _records)
                : Table([typeof(string)], []);
        }

        if (!text.Contains($"FROM {table} ", StringComparison.Ordinal))
        {
            throw new MySqlException(1146, $"Table '{text}' doesn't exist");
        }

        Interlocked.Increment(ref _sampleQueries);
        int line = (int)parameters["@row"];
        int first = (int)parameters["@first"];
        double[] radii = new double[(int)parameters["@last"] - first + 1];
        _grid.ReadRadii(line, first, radii);
        return Table([typeof(double)], radii.Where((_, i) => first + i != MissingColumn).Select(radius => new object[] { radius }));
    }

    private static DataTable Table(Type[] columns, IEnumerable<object[]> rows)
    {
        DataTable table = new() { Locale = CultureInfo.InvariantCulture };
        for (int i = 0; i < columns.Length; i++)
        {
            table.Columns.Add($"c{i}", columns[i]);
        }

        foreach (object[] row in rows)
        {
            table.Rows.Add(row);
        }

        return table;
    }
}
