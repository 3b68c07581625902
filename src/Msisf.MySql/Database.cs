using System.Data.Common;
using MySqlConnector;

namespace Msisf.MySql;

/// <summary>The database of the elevation tables; each query uses its own connection. Thread-safe.</summary>
public sealed class Database : IDisposable
{
    /// <summary>
    /// Maximum time for a cancelled query to end. Without it, a hanging server would delay the end by the sum of the provider's own time
    /// limits.
    /// </summary>
    internal static readonly TimeSpan CancelPatience = TimeSpan.FromSeconds(2);

    private readonly MySqlDataSource _source;
    private readonly string _server;
    private readonly CancellationToken _cancellation;
    private volatile bool _isAbandoned;

    /// <summary>Creates a database from a source of connections.</summary>
    /// <param name="source">Source of connections; disposed with this object.</param>
    /// <param name="server">Name of the server, for messages.</param>
    /// <param name="cancellation">Cancels queries.</param>
    internal Database(MySqlDataSource source, string server, CancellationToken cancellation)
    {
        _source = source;
        _server = server;
        _cancellation = cancellation;
    }

    /// <summary>Prepares the database; no connection is opened yet.</summary>
    /// <param name="settings">Server, user and encryption.</param>
    /// <param name="cancellation">Cancels queries, at the latest after 2 s.</param>
    /// <exception cref="ExternalPartException">The server's socket is missing.</exception>
    public static Database Open(DatabaseSettings settings, CancellationToken cancellation)
    {
        try
        {
            return new Database(new MySqlDataSource(ConnectionText.Of(settings)), settings.Server, cancellation);
        }
        catch (Exception exception)
        {
            throw DatabaseFailure.Of(exception, settings.Server);
        }
    }

    /// <summary>Closes the connections, unless a cancelled query did not end; then they stay open until the process ends.</summary>
    public void Dispose()
    {
        if (!_isAbandoned)
        {
            Task.WaitAny([Task.Run(_source.Dispose, CancellationToken.None)], CancelPatience);
        }
    }

    /// <summary>Runs one query.</summary>
    /// <param name="sql">The statement.</param>
    /// <param name="values">Parameters of the statement, by name.</param>
    /// <param name="read">Reads the result.</param>
    /// <exception cref="MsisfException">An exception of <paramref name="read"/>.</exception>
    /// <exception cref="ExternalPartException">The database failed in any way.</exception>
    /// <exception cref="OperationCanceledException">The query was cancelled, even if it did not end.</exception>
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
            // On another thread: to stop a query, the provider opens a second connection, which can block too.
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
            using MySqlConnection connection = _source.OpenConnection();
            using MySqlCommand command = connection.CreateCommand();
            command.CommandText = sql;
            foreach ((string name, object value) in values)
            {
                command.Parameters.AddWithValue(name, value);
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

/// <summary>The connection string of some settings.</summary>
internal static class ConnectionText
{
    /// <summary>The connection string of some settings.</summary>
    /// <remarks>No statement changes a session's state, so a pooled connection is used without the two statements that reset it.</remarks>
    public static string Of(DatabaseSettings settings)
    {
        MySqlConnectionStringBuilder builder = new()
        {
            Server = settings.Socket ?? settings.Host,
            UserID = settings.User,
            Password = settings.Password,
            Database = settings.Database,
            ConnectionReset = false,
            ConnectionProtocol = settings.Socket is null ? MySqlConnectionProtocol.Socket : MySqlConnectionProtocol.UnixSocket,
            SslMode = settings.Tls.Mode switch
            {
                TlsMode.Default => MySqlSslMode.Preferred,
                TlsMode.Disabled => MySqlSslMode.Disabled,
                TlsMode.Required => MySqlSslMode.Required,
                _ => MySqlSslMode.VerifyFull,
            },
        };
        if (settings.Port is int port)
        {
            builder.Port = (uint)port;
        }

        if (settings.Tls.CertificateAuthority is string authority)
        {
            builder.SslCa = Path.GetFullPath(authority);
        }

        return builder.ConnectionString;
    }
}
