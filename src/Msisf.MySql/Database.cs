using System.Data.Common;
using Msisf.Core.Errors;

namespace Msisf.MySql;

/// <summary>The database of the elevation tables. Safe for several threads: each query takes a connection of its own.</summary>
public sealed class Database : IDisposable
{
    /// <summary>
    /// How long a cancelled query may take to end; a server that hangs would take as long as the provider's own limits add up to.
    /// </summary>
    internal static readonly TimeSpan CancelPatience = TimeSpan.FromSeconds(2);

    private readonly DbDataSource _source;
    private readonly string _server;
    private readonly CancellationToken _cancellation;
    private volatile bool _isAbandoned;

    /// <summary>Over connections of any provider.</summary>
    /// <param name="source">Connections; disposed of with the database.</param>
    /// <param name="server">The server for messages.</param>
    /// <param name="cancellation">Ends queries.</param>
    internal Database(DbDataSource source, string server, CancellationToken cancellation)
    {
        _source = source;
        _server = server;
        _cancellation = cancellation;
    }

    /// <summary>Names the database; nothing is connected yet.</summary>
    /// <param name="settings">Where it is and who asks.</param>
    /// <param name="folder">Folder of the package MySqlConnector.</param>
    /// <param name="cancellation">Ends queries, at the latest after 2 s.</param>
    /// <exception cref="ExternalPartException">This build is without the package, or the server's socket is missing.</exception>
    public static Database Open(DatabaseSettings settings, string folder, CancellationToken cancellation)
    {
        DbProviderFactory provider = MySqlProvider.Load(folder);
        try
        {
            return new Database(provider.CreateDataSource(MySqlProvider.ConnectionString(settings)), settings.Server, cancellation);
        }
        catch (Exception exception)
        {
            throw DatabaseFailure.Of(exception, settings.Server);
        }
    }

    /// <summary>Closes the connections. Those of a query that did not end are left to the end of the process.</summary>
    public void Dispose()
    {
        if (!_isAbandoned)
        {
            Task.WaitAny([Task.Run(_source.Dispose, CancellationToken.None)], CancelPatience);
        }
    }

    /// <summary>Asks one question.</summary>
    /// <param name="sql">The statement.</param>
    /// <param name="values">Its parameters, by name.</param>
    /// <param name="read">Reads the answer.</param>
    /// <exception cref="MsisfException">Of <paramref name="read"/>.</exception>
    /// <exception cref="ExternalPartException">The database failed in any way.</exception>
    /// <exception cref="OperationCanceledException">Cancelled, also if the query did not end.</exception>
    internal T Query<T>(string sql, IEnumerable<(string Name, object Value)> values, Func<DbDataReader, T> read)
    {
        CancellationTokenSource stop = new();
        Task<T> answer = Task.Run(() => Answer(sql, values, read, stop.Token), CancellationToken.None);
        try
        {
            Task.WaitAny([answer], _cancellation);
        }
        catch (OperationCanceledException)
        {
            // On another thread: to stop a query, the provider connects a second time, which can block too.
            _ = stop.CancelAsync();
            _isAbandoned |= Task.WaitAny([answer], CancelPatience) < 0;
            throw;
        }

        return answer.GetAwaiter().GetResult();
    }

    private T Answer<T>(string sql, IEnumerable<(string Name, object Value)> values, Func<DbDataReader, T> read, CancellationToken stop)
    {
        try
        {
            using DbConnection connection = _source.OpenConnection();
            using DbCommand command = connection.CreateCommand();
            command.CommandText = sql;
            foreach ((string name, object value) in values)
            {
                DbParameter parameter = command.CreateParameter();
                parameter.ParameterName = name;
                parameter.Value = value;
                command.Parameters.Add(parameter);
            }

            stop.ThrowIfCancellationRequested();
            using CancellationTokenRegistration registration = stop.Register(command.Cancel);
            using DbDataReader reader = command.ExecuteReader();
            return read(reader);
        }
        catch (Exception exception) when (exception is not MsisfException)
        {
            throw DatabaseFailure.Of(exception, _server);
        }
    }
}
