using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using System.Text;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using MySqlConnector;
using Xunit;

namespace Msisf.MySql.Tests;

/// <summary>However a server fails, the error is one line with exit code 3; a server that hangs does not keep the program.</summary>
[Collection(PrivateServer.Collection)]
public class DatabaseTests(PrivateServer server)
{
    private const string LongQuery = "SELECT SLEEP(60)";
    private const string Connecting = "Is the server running, and are host, port or socket right?";
    private const double Seconds = 30.0; // far above what any step takes, and below the sleep of the query

    [RequiresTheory(Part.MariaDb)]
    [InlineData("PASSWORD", "wrong", "Access denied for user 'reader'@'127.0.0.1' (using password: YES) (error 1045). "
        + "Check user and password in the option file or in MSISF_DB_USER and MSISF_DB_PASSWORD.")]
    [InlineData("DATABASE", "nowhere", "Unknown database 'nowhere' (error 1049). "
        + "Make it with scripts/ldem_mysql_insert.php --create, as a user who may.")]
    [InlineData("DATABASE", "mysql", "Table 'mysql.ldem_import' doesn't exist (error 1146). "
        + "Import the elevation model first (scripts/ldem_mysql_insert.php).")]
    public void Query_RefusedByTheServer_SaysWhyAndWhatToDo(string option, string value, string message)
    {
        Assert.Equal($"database 127.0.0.1:{server.Port}: {message}", ErrorOf(server.NetworkSettings((option, value))));
    }

    [RequiresFact(Part.MariaDb)]
    public void Query_CertificateOfAnotherAuthority_IsNotBelieved()
    {
        string message = ErrorOf(server.NetworkSettings(("SSL_CA", server.OtherAuthorityFile)));

        Assert.Contains("RemoteCertificateChainErrors", message, StringComparison.Ordinal);
        Assert.EndsWith(
            ". Does the server's certificate come from the authority in ssl-ca, and does it name the host?",
            message, StringComparison.Ordinal);
    }

    [RequiresFact(Part.MariaDb)]
    public void Query_VerifiedServer_IsReadEncrypted()
    {
        using Database database = Database.Open(server.NetworkSettings(("SSL_CA", server.AuthorityFile)), default);

        string cipher = database.Query("SHOW STATUS LIKE 'Ssl_cipher'", [], reader => reader.Read() ? reader.GetString(1) : string.Empty);

        Assert.NotEmpty(cipher);
    }

    [RequiresFact(Part.MariaDb)]
    public void Query_WithoutRights_SaysSo()
    {
        server.Execute("CREATE OR REPLACE USER nobody@'127.0.0.1'");

        Assert.Equal(
            $"database 127.0.0.1:{server.Port}: Access denied for user 'nobody'@'127.0.0.1' to database 'mysql' (error 1044). "
                + "The user lacks rights; docs/database.md lists those that are needed.",
            ErrorOf(server.NetworkSettings(("USER", "nobody"), ("PASSWORD", string.Empty), ("DATABASE", "mysql"))));
    }

    [RequiresFact(Part.MariaDb)]
    public void Query_OtherError_HasItsNumber()
    {
        using Database database = Database.Open(server.Settings("mysql"), default);

        string message = Assert.Throws<ExternalPartException>(() => database.Query("SELECT 1 +", [], _ => 0)).Message;

        Assert.EndsWith("(error 1064). The server's documentation explains the number.", message, StringComparison.Ordinal);
        Assert.DoesNotContain('\n', message);
    }

    [RequiresFact(Part.MariaDb)]
    public void Query_OurOwnError_StaysWhatItIsAndGivesTheConnectionBack()
    {
        using Database database = OneConnection("");

        for (int i = 0; i < 2; i++) // the second one would wait in vain for the only connection
        {
            Assert.Throws<BadInputException>(() => database.Query<int>("SELECT 1", [], _ => throw new BadInputException("x")));
        }
    }

    [RequiresFact(Part.MariaDb)]
    public void Query_LongerThanTheTimeLimit_SaysSo()
    {
        using Database database = OneConnection("Default Command Timeout=1");

        string message = Assert.Throws<ExternalPartException>(() => database.Query(LongQuery, [], reader => reader.Read())).Message;

        Assert.StartsWith("database db: The Command Timeout expired before the operation completed", message, StringComparison.Ordinal);
        Assert.EndsWith(Connecting, message, StringComparison.Ordinal);
    }

    [RequiresFact(Part.MariaDb)]
    public async Task Query_ConnectionKilledByTheServer_SaysThatItBrokeOff()
    {
        using Database database = OneConnection("");
        Task<bool> query = Task.Run(() => database.Query(LongQuery, [], reader => reader.Read()));
        await UntilItRunsAsync(LongQuery);

        server.Execute($"KILL {Running(LongQuery)}");
        ExternalPartException exception = await Assert.ThrowsAsync<ExternalPartException>(
            () => Within.Seconds(Seconds, "the end of the query", query));

        Assert.StartsWith("database db: ", exception.Message, StringComparison.Ordinal);
        Assert.EndsWith(
            "The connection broke off: restart the server if it is down, and run this again; finished patterns are kept.",
            exception.Message, StringComparison.Ordinal);
    }

    [RequiresFact(Part.MariaDb)]
    public async Task Query_CancelledWhileTheServerWorks_StopsTheQuery()
    {
        using CancellationTokenSource cancellation = new();
        using Database database = Database.Open(server.Settings("mysql"), cancellation.Token);
        Task<bool> query = Task.Run(() => database.Query(LongQuery, [], reader => reader.Read()));
        await UntilItRunsAsync(LongQuery);

        await cancellation.CancelAsync();

        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => Within.Seconds(Seconds, "the end of the query", query));
        Assert.Null(Running(LongQuery));
    }

    /// <summary>Without the limit the provider tries for 15 s to connect a second time, by which it would stop the query.</summary>
    [RequiresFact(Part.MariaDb)]
    public async Task Query_CancelledWhileTheServerHangs_EndsWithinTheLimit()
    {
        const double providersPatience = 15.0;
        const string hangingQuery = "SELECT SLEEP(61)"; // nobody waits for its end, and no other test takes it for its own
        using CancellationTokenSource cancellation = new();
        Database database = Database.Open(server.NetworkSettings(), cancellation.Token);
        Task<bool> query = Task.Run(() =>
        {
            using (database)
            {
                return database.Query(hangingQuery, [], reader => reader.Read());
            }
        });
        await UntilItRunsAsync(hangingQuery);
        server.Hang(true);
        try
        {
            long start = Stopwatch.GetTimestamp();
            await cancellation.CancelAsync();
            await Assert.ThrowsAnyAsync<OperationCanceledException>(() => Within.Seconds(Seconds, "the end of the query", query));
            Assert.InRange(Stopwatch.GetElapsedTime(start).TotalSeconds, Database.CancelPatience.TotalSeconds, providersPatience);
        }
        finally
        {
            server.Hang(false);
        }
    }

    [Fact]
    public void Query_NobodyListens_SaysSo()
    {
        int port = PrivateServer.FreePort();

        Assert.Equal(
            $"database 127.0.0.1:{port}: Unable to connect to any of the specified MySQL hosts (error 1042). {Connecting}",
            ErrorOf(AtPort(port)));
    }

    [Theory]
    [InlineData(
        "HTTP/1.1 400 Bad Request\r\nConnection: close\r\n\r\n",
        "Is it a MySQL or MariaDB server that answers there? Check host and port.")]
    [InlineData("", Connecting)]
    public async Task Query_AnotherKindOfServer_SaysSo(string greeting, string advice)
    {
        using TcpListener listener = new(IPAddress.Loopback, 0);
        listener.Start();
        Task answering = Task.Run(async () =>
        {
            using TcpClient client = await listener.AcceptTcpClientAsync();
            await client.GetStream().WriteAsync(Encoding.ASCII.GetBytes(greeting));
        });

        string message = ErrorOf(AtPort(((IPEndPoint)listener.LocalEndpoint).Port));

        await Within.Seconds(Seconds, "the answer", answering);
        Assert.EndsWith(advice, message, StringComparison.Ordinal);
    }

    [Fact]
    public void Open_SocketThatIsMissing_IsAnExternalPart()
    {
        using TemporaryFolder folder = new();
        DatabaseSettings settings = DatabaseSettings.Read(
            null, name => name switch { "MSISF_DB_USER" => "reader", "MSISF_DB_SOCKET" => folder["no.sock"], _ => null });

        Assert.Equal(
            $"database {folder["no.sock"]}: Cannot find Unix Socket at {folder["no.sock"]}. {Connecting}",
            Assert.Throws<ExternalPartException>(() => Database.Open(settings, default)).Message);
    }

    private static string ErrorOf(DatabaseSettings settings)
    {
        using Database database = Database.Open(settings, CancellationToken.None);
        return Assert.Throws<ExternalPartException>(() => LdemTableGrid.Open(database, 4)).Message;
    }

    private DatabaseSettings AtPort(int port) => server.NetworkSettings(("PORT", $"{port}"));

    /// <summary>A database with one connection at most.</summary>
    private Database OneConnection(string options) => new(
        new MySqlDataSource($"{ConnectionText.Of(server.Settings("mysql"))};Maximum Pool Size=1;{options}"), "db", CancellationToken.None);

    private Task UntilItRunsAsync(string query) => Within.Seconds(Seconds, "the query", () => Running(query) is not null);

    /// <summary>The number of the connection that runs a query; null if there is none.</summary>
    private object? Running(string query) => server.Value($"SELECT id FROM information_schema.processlist WHERE info = '{query}'");
}
