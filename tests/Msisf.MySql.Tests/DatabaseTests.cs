using System.Data;
using System.Diagnostics;
using System.Net.Sockets;
using System.Security.Authentication;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using MySqlConnector;
using Xunit;

namespace Msisf.MySql.Tests;

/// <summary>Whatever a provider throws is one line and exit code 3; a provider that blocks does not keep the program.</summary>
public sealed class DatabaseTests : IDisposable
{
    private const string GoesOn =
        "The connection broke off: restart the server if it is down, and run this again; finished patterns are kept.";
    private const string Foreign = "Is it a MySQL or MariaDB server that answers there? Check host and port.";

    /// <summary>Beside the limit itself, for two busy cores.</summary>
    private static readonly TimeSpan Slack = TimeSpan.FromSeconds(2);

    private readonly TemporaryFolder _folder = new();

    public static TheoryData<string, string> Failures => new()
    {
        { "refused", "Unable to connect to any of the specified MySQL hosts: Connection refused (error 1042). "
            + "Is the server running, and are host, port or socket right?" },
        { "password", "Access denied for user 'x'@'y' (using password: YES) (error 1045). "
            + "Check user and password in the option file or in MSISF_DB_USER and MSISF_DB_PASSWORD." },
        {
            "table",
            "Table 'msisf.ldem_import' doesn't exist (error 1146). Import the elevation model first (scripts/ldem_mysql_insert.php)."
        },
        { "other error", "Something else (error 1234). The server's documentation explains the number." },
        { "time limit", "The Command Timeout expired before the operation completed. "
            + "Is the server running, and are host, port or socket right?" },
        { "certificate", "SSL Authentication Error: The remote certificate was rejected. "
            + "Does the server's certificate come from the authority in ssl-ca, and does it name the host?" },
        { "socket", $"Broken pipe. {GoesOn}" },
        { "end of stream", $"An incomplete response was received from the server. {GoesOn}" },
        { "within an error", $"Failed to read the result set: Connection reset by peer. {GoesOn}" },
        { "protocol", $"Packet received out-of-order. Expected 0; got 72. {Foreign}" },
        { "format", $"The input string 'x' was not in a correct format. {Foreign}" },
        { "index", $"Index was outside the bounds of the array. {Foreign}" },
        { "cancelled by the provider", $"A task was canceled. {Foreign}" },
    };

    public void Dispose() => _folder.Dispose();

    [Theory]
    [MemberData(nameof(Failures))]
    public void Query_AnyFailureOfTheProvider_IsOneLineThatNamesTheServer(string failure, string message)
    {
        FakeDataSource atQuery = new((_, _) => throw Failure(failure));
        FakeDataSource atOpening = new((_, _) => new DataTable()) { Opening = () => throw Failure(failure) };

        foreach (FakeDataSource source in (FakeDataSource[])[atQuery, atOpening])
        {
            using Database database = new(source, "db.example:3307", CancellationToken.None);
            ExternalPartException exception = Assert.Throws<ExternalPartException>(() => LdemTableGrid.Open(database, 4));
            Assert.Equal($"database db.example:3307: {message}", exception.Message);
            Assert.Equal(0, source.OpenConnections);
        }
    }

    [Fact]
    public void Query_ConnectionLostInTheMiddle_IsAnExternalPart()
    {
        FakeMoon moon = new(FunctionGrid.Rough(2), FakeMoon.Record("TEST_GRID"));
        bool isLost = false;
        FakeDataSource source = new((text, values) => isLost ? throw new MySqlEndOfStreamException() : moon.Answer(text, values));
        using Database database = new(source, "/run/my.sock", CancellationToken.None);
        LdemTableGrid grid = LdemTableGrid.Open(database, 2);
        grid.ReadRadii(0, 0, new double[720]);
        isLost = true;

        ExternalPartException exception = Assert.Throws<ExternalPartException>(() => grid.ReadRadii(1, 0, new double[720]));

        Assert.StartsWith("database /run/my.sock: An incomplete response", exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Query_OurOwnError_StaysWhatItIs()
    {
        using Database database = new(new FakeDataSource((_, _) => new DataTable()), "db", CancellationToken.None);
        Assert.Throws<BadInputException>(() => database.Query<int>("SELECT 1", [], _ => throw new BadInputException("x")));
    }

    [Fact]
    public async Task Query_CancelledWhileTheServerHangs_EndsWithinTheLimit()
    {
        using ManualResetEventSlim isAsked = new();
        using ManualResetEventSlim release = new();
        using CancellationTokenSource cancellation = new();
        void Block() => release.Wait(TimeSpan.FromMinutes(1));
        FakeDataSource source = new((_, _) =>
        {
            isAsked.Set();
            Block();
            return new DataTable();
        })
        {
            Cancelling = Block,
            Closing = Block,
        };
        Database database = new(source, "db", cancellation.Token);
        Task run = Task.Run(() =>
        {
            using (database)
            {
                LdemTableGrid.Open(database, 4);
            }
        });
        Assert.True(isAsked.Wait(TimeSpan.FromSeconds(30)));

        long start = Stopwatch.GetTimestamp();
        await cancellation.CancelAsync();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => run.WaitAsync(TimeSpan.FromSeconds(30)));
        TimeSpan elapsed = Stopwatch.GetElapsedTime(start);
        release.Set();

        Assert.InRange(elapsed, Database.CancelPatience, Database.CancelPatience + Slack);
        Assert.Equal(TimeSpan.FromSeconds(2), Database.CancelPatience);
    }

    [Fact]
    public async Task Query_CancelledWhileTheServerWorks_StopsTheQueryAndWaitsForIt()
    {
        using ManualResetEventSlim isAsked = new();
        using ManualResetEventSlim isStopped = new();
        using CancellationTokenSource cancellation = new();
        bool hasClosed = false;
        FakeDataSource source = new((_, _) =>
        {
            isAsked.Set();
            Assert.True(isStopped.Wait(TimeSpan.FromMinutes(1)));
            throw new MySqlException(1317, "Query execution was interrupted");
        })
        {
            Cancelling = isStopped.Set,
            Closing = () => hasClosed = true,
        };
        Database database = new(source, "db", cancellation.Token);
        Task run = Task.Run(() => LdemTableGrid.Open(database, 4));
        Assert.True(isAsked.Wait(TimeSpan.FromSeconds(30)));

        await cancellation.CancelAsync();

        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => run.WaitAsync(TimeSpan.FromSeconds(30)));
        Assert.Equal(0, source.OpenConnections);
        database.Dispose();
        Assert.True(hasClosed);
    }

    [Fact]
    public void Open_SocketThatIsMissing_IsAnExternalPart()
    {
        ExternalPartException exception = Assert.Throws<ExternalPartException>(
            () => Database.Open(Settings(), AppContext.BaseDirectory, default));
        Assert.Equal(
            $"database {_folder["no.sock"]}: Cannot find Unix Socket at {_folder["no.sock"]}. "
                + $"Is the server running, and are host, port or socket right?", exception.Message);
    }

    [Fact]
    public void Open_SocketThatIsThere_ReadsTheDatabase()
    {
        _folder.Write("no.sock", string.Empty);
        using Database database = Database.Open(Settings(), AppContext.BaseDirectory, default);
        Assert.StartsWith(
            "table ldem_4: no elevation model",
            Assert.Throws<BadInputException>(() => LdemTableGrid.Open(database, 4)).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Open_BuildWithoutTheProvider_SaysSo()
    {
        ExternalPartException exception = Assert.Throws<ExternalPartException>(() => Database.Open(Settings(), _folder["."], default));
        Assert.StartsWith("this build of msis has no MySqlConnector", exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Open_DamagedFileOfTheProvider_SaysSo()
    {
        string path = _folder.Write("MySqlConnector.dll", "MZ damaged");
        ExternalPartException exception = Assert.Throws<ExternalPartException>(() => Database.Open(Settings(), _folder.Path, default));
        Assert.StartsWith($"{path}: can't be loaded: ", exception.Message, StringComparison.Ordinal);
        Assert.EndsWith("damaged or do not fit: remove publish/ and run scripts/build.sh.", exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Query_MissingFileOfTheProvider_SaysSo()
    {
        using Database database = new(
            new FakeDataSource(
                (_, _) => throw new FileNotFoundException(
                    "Could not load file or assembly 'Microsoft.Extensions.Logging.Abstractions'.")), "db", default);
        ExternalPartException exception = Assert.Throws<ExternalPartException>(() => LdemTableGrid.Open(database, 4));
        Assert.StartsWith("MySqlConnector: can't be loaded: Could not load file or assembly", exception.Message, StringComparison.Ordinal);
    }

    /// <summary>As the package throws them; a socket's message is the system's.</summary>
    private static Exception Failure(string name) => name switch
    {
        "refused" => new MySqlException(
            1042, "Unable to connect to any of the specified MySQL hosts.", new SocketException(0, "Connection refused")),
        "password" => new MySqlException(1045, "Access denied for user 'x'@'y' (using password: YES)"),
        "table" => new MySqlException(1146, "Table 'msisf.ldem_import' doesn't exist"),
        "other error" => new MySqlException(1234, "Something\nelse"),
        "time limit" => new MySqlException(-1, "The Command Timeout expired before the operation completed."),
        "certificate" =>
            new MySqlException(0, "SSL Authentication Error", new AuthenticationException("The remote certificate was rejected.")),
        "socket" => new SocketException(0, "Broken pipe"),
        "end of stream" => new MySqlEndOfStreamException(),
        "within an error" => new MySqlException(
            0, "Failed to read the result set.", new IOException("x", new SocketException(0, "Connection reset by peer"))),
        "protocol" => new MySqlProtocolException(),
        "format" => new FormatException("The input string 'x' was not in a correct format."),
        "index" => Record.Exception(() => Array.Empty<int>()[0])!,
        "cancelled by the provider" => new TaskCanceledException(),
        _ => throw new ArgumentOutOfRangeException(nameof(name)),
    };

    private DatabaseSettings Settings() => DatabaseSettings.Read(null, name => name switch
    {
        "MSISF_DB_USER" => "reader",
        "MSISF_DB_SOCKET" => _folder["no.sock"],
        _ => null,
    });
}
