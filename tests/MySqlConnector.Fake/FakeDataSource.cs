using System.Data;
using System.Data.Common;

namespace MySqlConnector;

/// <summary>A database that answers each query by a function of its text and parameters.</summary>
public sealed class FakeDataSource(
    Func<string, IReadOnlyDictionary<string, object>, DataTable> answer, string connectionString = "") : DbDataSource
{
    private int _openConnections;

    public override string ConnectionString => connectionString;

    /// <summary>How many connections were not given back.</summary>
    public int OpenConnections => _openConnections;

    protected override DbConnection CreateDbConnection() =>
        new FakeConnection(answer, change => Interlocked.Add(ref _openConnections, change));
}
