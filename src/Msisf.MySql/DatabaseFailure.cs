using System.Data.Common;
using System.Security.Authentication;
using MySqlConnector;

namespace Msisf.MySql;

/// <summary>Converts exceptions of the provider to an error that names the server and advises what to do.</summary>
internal static class DatabaseFailure
{
    private const string Connecting = "Is the server running, and are host, port or socket right?";
    private const string BrokenOff =
        "The connection broke off: restart the server if it is down, and run this again; finished patterns are kept.";

    private const string Rights = "The user lacks rights; docs/database.md lists those that are needed.";

    /// <summary>Advice by the server's error number; the PHP scripts give the same advice.</summary>
    private static readonly Dictionary<int, string> Advice = new()
    {
        [1040] = "Try again later, or raise max_connections.",
        [1042] = Connecting,
        [1044] = Rights,
        [1045] = "Check user and password in the option file or in MSISF_DB_USER and MSISF_DB_PASSWORD.",
        [1049] = "Make it with scripts/ldem_mysql_insert.php --create, as a user who may.",
        [1142] = Rights,
        [1146] = "Import the elevation model first (scripts/ldem_mysql_insert.php).",
        [1698] = "This user logs in by the socket, not by a password (docs/database.md, In short).",
    };

    /// <summary>Converts a failure of the connection or of a statement.</summary>
    /// <param name="exception">What the provider threw.</param>
    /// <param name="server">Name of the server, for messages.</param>
    public static ExternalPartException Of(Exception exception, string server)
    {
        int number = exception is MySqlException { Number: > 0 and int code } ? code : 0; // others are the provider's own
        string shown = number > 0 ? $" (error {number})" : string.Empty;
        return new ExternalPartException($"database {server}: {What(exception)}{shown}. {AdviceFor(exception, number)}", exception);
    }

    /// <summary>The exception's message and that of its innermost cause, on one line, without a full stop.</summary>
    private static string What(Exception exception)
    {
        string text = Clean(exception.Message);
        string cause = Clean(exception.GetBaseException().Message);
        return text.Contains(cause, StringComparison.Ordinal) ? text : $"{text}: {cause}";
    }

    private static string Clean(string message) => message.ReplaceLineEndings(" ").TrimEnd('.', ' ');

    private static string AdviceFor(Exception exception, int number)
    {
        Exception cause = exception.GetBaseException();
        if (cause is not AuthenticationException && Advice.TryGetValue(number, out string? advice)) // to the provider it is a 1042, too
        {
            return advice;
        }

        return cause switch
        {
            AuthenticationException => "Does the server's certificate come from the authority in ssl-ca, and does it name the host?",
            IOException or System.Net.Sockets.SocketException => BrokenOff,
            DbException => number > 0 ? "The server's documentation explains the number." : Connecting,
            _ => "Is it a MySQL or MariaDB server that answers there? Check host and port.",
        };
    }
}
