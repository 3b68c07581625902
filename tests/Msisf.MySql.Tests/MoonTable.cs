using System.Data;
using System.Globalization;
using Msisf.Core.Terrain;

namespace Msisf.MySql.Tests;

/// <summary>
/// A database with the tables of docs/database.md, of which it has the columns that msis reads, and a grid in them. Counts the questions
/// that the server is asked.
/// </summary>
internal sealed class MoonTable : IDisposable
{
    private static int Databases;

    private readonly PrivateServer _server;
    private readonly long _questionsBefore;

    /// <param name="server">Where.</param>
    /// <param name="grid">What is in the table.</param>
    /// <param name="lines">The lines that are; null for all.</param>
    /// <param name="records">Rows of ldem_import, by <see cref="Record"/>.</param>
    public MoonTable(PrivateServer server, IGlobalGrid grid, IEnumerable<int>? lines, params object[][] records)
    {
        _server = server;
        Name = string.Create(CultureInfo.InvariantCulture, $"moon_{Interlocked.Increment(ref Databases)}");
        Table = string.Create(CultureInfo.InvariantCulture, $"ldem_{grid.PixelsPerDegree}");
        server.Execute($"""
            CREATE DATABASE {Name};
            CREATE TABLE {Name}.ldem_import (table_name VARCHAR(64), product_id VARCHAR(64), state VARCHAR(16),
                format_version SMALLINT UNSIGNED, rows_done INT UNSIGNED, row_count INT UNSIGNED, first_row MEDIUMINT UNSIGNED,
                first_col MEDIUMINT UNSIGNED AUTO_INCREMENT PRIMARY KEY);
            CREATE TABLE {Name}.{Table} (row_index MEDIUMINT UNSIGNED NOT NULL, col_index MEDIUMINT UNSIGNED NOT NULL,
                planetary_radius DOUBLE NOT NULL, PRIMARY KEY (row_index, col_index))
            """);
        foreach (object[] record in records)
        {
            server.Execute(string.Create(
                CultureInfo.InvariantCulture,
                $"INSERT INTO {Name}.ldem_import VALUES ('{Table}', '{record[0]}', '{record[1]}', {record[2]}, {record[3]}, {record[4]}, "
                    + $"0, 0)"));
        }

        server.Fill(Name, Table, Rows(grid, lines ?? Enumerable.Range(0, 180 * grid.PixelsPerDegree)));
        Database = Database.Open(server.Settings(Name), CancellationToken.None);
        _questionsBefore = Questions;
    }

    /// <summary>Name of the database.</summary>
    public string Name { get; }

    /// <summary>Name of the table of samples.</summary>
    public string Table { get; }

    /// <summary>The database as msis opens it.</summary>
    public Database Database { get; }

    /// <summary>
    /// How many SELECTs the server got since it was made, but for that of the import's record and the one that counted before.
    /// </summary>
    public long SampleQueries => Questions - _questionsBefore - 2;

    /// <summary>A row of ldem_import: product, state, format, lines done, lines.</summary>
    public static object[] Record(string product, string state = "complete", int format = 1, int done = 360, int all = 360) =>
        [product, state, format, done, all];

    public void Dispose()
    {
        Database.Dispose();
        _server.Execute($"DROP DATABASE {Name}");
    }

    private long Questions => Convert.ToInt64(
        _server.Value("SELECT VARIABLE_VALUE FROM information_schema.GLOBAL_STATUS WHERE VARIABLE_NAME = 'COM_SELECT'"),
        CultureInfo.InvariantCulture);

    private static DataTable Rows(IGlobalGrid grid, IEnumerable<int> lines)
    {
        DataTable rows = new() { Locale = CultureInfo.InvariantCulture };
        rows.Columns.Add("row_index", typeof(int));
        rows.Columns.Add("col_index", typeof(int));
        rows.Columns.Add("planetary_radius", typeof(double));
        double[] radii = new double[360 * grid.PixelsPerDegree];
        foreach (int line in lines)
        {
            grid.ReadRadii(line, 0, radii);
            for (int sample = 0; sample < radii.Length; sample++)
            {
                rows.Rows.Add(line, sample, radii[sample]);
            }
        }

        return rows;
    }
}
