using System.Net.Sockets;
using System.Security.Authentication;
using Xunit;

namespace Msisf.MySql.Tests;

/// <summary>What a provider may throw beside its own exception, of which DatabaseTests has real ones.</summary>
public class DatabaseFailureTests
{
    private const string GoesOn =
        "The connection broke off: restart the server if it is down, and run this again; finished patterns are kept.";
    private const string Foreign = "Is it a MySQL or MariaDB server that answers there? Check host and port.";

    public static TheoryData<Exception, string> Exceptions => new()
    {
        { new SocketException(0, "Broken pipe"), $"Broken pipe. {GoesOn}" },
        {
            new InvalidOperationException(
                "Failed to read\nthe result set.", new IOException("x", new SocketException(0, "Connection reset"))),
            $"Failed to read the result set: Connection reset. {GoesOn}"
        },
        {
            new IOException("No secure connection.", new AuthenticationException("The remote certificate was rejected.")),
            "No secure connection: The remote certificate was rejected. "
                + "Does the server's certificate come from the authority in ssl-ca, and does it name the host?"
        },
        { new FormatException("The input string 'x' was not in a correct format."),
            $"The input string 'x' was not in a correct format. {Foreign}" },
        { new TaskCanceledException(), $"A task was canceled. {Foreign}" },
    };

    [Theory]
    [MemberData(nameof(Exceptions))]
    public void Of_AnyException_IsOneLineThatNamesTheServer(Exception exception, string message) => Assert.Equal(
        $"database db.example:3307: {message}", DatabaseFailure.Of(exception, "db.example:3307").Message);
}
