using System.Data;
using System.Data.Common;

namespace MySqlConnector;

/// <summary>A database that answers each query by a function of its text and parameters.</summary>
public sealed class FakeDataSource(
    Func<string, IReadOnlyDictionary<string, object>, DataTable> answer, string connectionString = "") : DbDataSource
{
    private int _openConnections;

    public override string ConnectionString => connectionString;

    /// <summary>Called when a connection is opened.</summary>
    public Action Opening { get; init; } = () => { };

    /// <summary>Called to stop a query, as the package connects a second time for it.</summary>
    public Action Cancelling { get; init; } = () => { };

    /// <summary>Called when the source is closed.</summary>
    public Action Closing { get; init; } = () => { };

    /// <summary>How many connections were not given back.</summary>
    public int OpenConnections => _openConnections;

    internal void CountOpen(int change) => Interlocked.Add(ref _openConnections, change);

    internal DataTable Answer(string text, IReadOnlyDictionary<string, object> parameters) => answer(text, parameters);

    protected override DbConnection CreateDbConnection() => new FakeConnection(this);

    protected override void Dispose(bool disposing)
    {
        Closing();
        base.Dispose(disposing);
    }
}
