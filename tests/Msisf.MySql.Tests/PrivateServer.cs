using System.Globalization;
using System.Net;
using System.Net.Sockets;
using Msisf.TestSupport;
using MySqlConnector;
using Xunit;

namespace Msisf.MySql.Tests;

/// <summary>
/// A MariaDB of the tests' own, started once: own folder, a socket, and 127.0.0.1 with a certificate. Without it the tests that need it are
/// skipped by its name.
/// </summary>
public sealed class PrivateServer : IAsyncLifetime, IDisposable
{
    /// <summary>The collection of the tests that use it; one at a time.</summary>
    public const string Collection = "MariaDB";

    /// <summary>A user who may read, over the network.</summary>
    public const string Reader = "reader";

    /// <summary>His password.</summary>
    public const string Password = "geheim;7x!'\"";

    private const double StartSeconds = 60.0; // far above what it takes, even on a busy machine

    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("msisf-mariadb-"); // its set-up script takes no blanks
    private readonly CertificateAuthority _authority = new("Moon CA");
    private RunningProgram? _program;

    /// <summary>The server's socket.</summary>
    public string Socket => At("socket");

    /// <summary>Its port at 127.0.0.1.</summary>
    public int Port { get; } = FreePort();

    /// <summary>PEM file of the authority that signed its certificate.</summary>
    public string AuthorityFile => At("ca.pem");

    /// <summary>PEM file of an authority that did not.</summary>
    public string OtherAuthorityFile => At("other.pem");

    /// <summary>Makes and starts the server.</summary>
    public async Task InitializeAsync()
    {
        if (MissingParts.ReasonToSkip([Part.MariaDb]) is not null)
        {
            return;
        }

        ChildRun.Of(
            TestParts.Program("mariadb-install-db") ?? throw new InvalidOperationException("mariadb-install-db is not on the PATH"),
            ["--no-defaults", $"--datadir={At("data")}", $"--user={Environment.UserName}", "--auth-root-authentication-method=normal",
             "--skip-test-db"],
            _folder.FullName).Succeeded();
        using CertificateAuthority other = new("Other CA");
        File.WriteAllText(AuthorityFile, _authority.Certificate);
        File.WriteAllText(OtherAuthorityFile, other.Certificate);
        (string certificate, string key) = _authority.Sign("127.0.0.1", IPAddress.Loopback);
        File.WriteAllText(At("server.pem"), certificate);
        File.WriteAllText(At("server.key"), key);
        _program = RunningProgram.Start(
            TestParts.MariaDb ?? throw new InvalidOperationException("mariadbd is not on the PATH"),
            ["--no-defaults", $"--user={Environment.UserName}", $"--datadir={At("data")}", $"--socket={Socket}",
             "--bind-address=127.0.0.1", string.Create(CultureInfo.InvariantCulture, $"--port={Port}"), "--skip-name-resolve",
             $"--ssl-cert={At("server.pem")}", $"--ssl-key={At("server.key")}", "--local-infile=1",
             "--innodb-flush-log-at-trx-commit=0"],
            _folder.FullName);
        await Within.Seconds(StartSeconds, "the answer of mariadbd", IsThere);
        Execute($"CREATE USER {Reader}@'127.0.0.1' IDENTIFIED BY '{MySqlHelper.EscapeString(Password)}'");
        Execute($"GRANT SELECT ON *.* TO {Reader}@'127.0.0.1'");
    }

    /// <summary>Nothing that would have to be waited for.</summary>
    public Task DisposeAsync() => Task.CompletedTask;

    /// <summary>Ends it.</summary>
    public void Dispose()
    {
        _program?.Dispose();
        _authority.Dispose();
        _folder.Delete(recursive: true);
    }

    /// <summary>Runs statements as the administrator, by the socket.</summary>
    public void Execute(string sql, string database = "") => Ask(sql, database, command => command.ExecuteNonQuery());

    /// <summary>The first column of the first row of an answer; null if there is none.</summary>
    public object? Value(string sql) => Ask(sql, string.Empty, command => command.ExecuteScalar());

    /// <summary>Fills a table by rows.</summary>
    public void Fill(string database, string table, System.Data.DataTable rows)
    {
        using MySqlConnection connection = Open(database);
        new MySqlBulkCopy(connection) { DestinationTableName = table }.WriteToServer(rows);
    }

    /// <summary>The settings of the administrator for a database, as the variables of the environment.</summary>
    public DatabaseSettings Settings(string database) => DatabaseSettings.Read(null, name => name switch
    {
        "MSISF_DB_USER" => "root",
        "MSISF_DB_SOCKET" => Socket,
        "MSISF_DB_DATABASE" => database,
        _ => null,
    });

    /// <summary>The settings of the reader, over the network.</summary>
    /// <param name="options">Those that are otherwise, under the names of the environment without MSISF_DB_.</param>
    public DatabaseSettings NetworkSettings(params (string Name, string Value)[] options)
    {
        Dictionary<string, string> values = new(StringComparer.Ordinal)
        {
            ["USER"] = Reader,
            ["PASSWORD"] = Password,
            ["HOST"] = "127.0.0.1",
            ["PORT"] = Port.ToString(CultureInfo.InvariantCulture),
            ["DATABASE"] = "information_schema",
        };
        foreach ((string name, string value) in options)
        {
            values[name] = value;
        }

        return DatabaseSettings.Read(null, name => values.GetValueOrDefault(name["MSISF_DB_".Length..]));
    }

    /// <summary>Stops the whole server, as a machine that hangs, or lets it go on.</summary>
    public void Hang(bool hangs) => ChildRun.Of(
        TestParts.Program("kill")!, [hangs ? "-STOP" : "-CONT", _program!.Id.ToString(CultureInfo.InvariantCulture)], _folder.FullName)
        .Succeeded();

    /// <summary>A port of 127.0.0.1 at which nobody listens.</summary>
    public static int FreePort()
    {
        using TcpListener listener = new(IPAddress.Loopback, 0);
        listener.Start();
        return ((IPEndPoint)listener.LocalEndpoint).Port;
    }

    private string At(string name) => Path.Combine(_folder.FullName, name);

    private bool IsThere()
    {
        try
        {
            return Value("SELECT 1") is not null;
        }
        catch (MySqlException) when (!_program!.EndsWithin(TimeSpan.Zero))
        {
            return false;
        }
    }

    private T Ask<T>(string sql, string database, Func<MySqlCommand, T> ask)
    {
        using MySqlConnection connection = Open(database);
        using MySqlCommand command = new(sql, connection);
        return ask(command);
    }

    private MySqlConnection Open(string database)
    {
        MySqlConnection connection = new(new MySqlConnectionStringBuilder
        {
            Server = Socket,
            ConnectionProtocol = MySqlConnectionProtocol.UnixSocket,
            UserID = "root",
            Database = database,
            AllowLoadLocalInfile = true,
            AllowUserVariables = true, // a host after @ looks like one
            Pooling = false,
        }.ConnectionString);
        connection.Open();
        return connection;
    }
}

/// <summary>The server for all tests that need it.</summary>
[CollectionDefinition(PrivateServer.Collection)]
public class TestsWithServer : ICollectionFixture<PrivateServer>;
