using System.Net;
using System.Text.RegularExpressions;

namespace Msisf.MySql;

/// <summary>
/// The server, user and encryption of the database connection, read as in the PHP scripts (docs/database.md). The password appears in no
/// message.
/// </summary>
public sealed partial class DatabaseSettings
{
    /// <summary>
    /// Default paths of the server's socket: packages of Debian, packages of Red Hat, and a server built from source or on macOS.
    /// </summary>
    internal static readonly IReadOnlyList<string> DefaultSockets =
        ["/run/mysqld/mysqld.sock", "/var/lib/mysql/mysql.sock", "/tmp/mysql.sock"];

    private const string DefaultDatabase = "msisf";
    private const string LocalHost = "localhost";

    private DatabaseSettings(Func<string, string?> valueOf)
    {
        User = valueOf("user") ?? throw new UsageException(
            "no database user. Give --defaults-file FILE with a [client] group, or set MSISF_DB_USER and MSISF_DB_PASSWORD.");
        Password = valueOf("password") ?? string.Empty;
        Database = DatabaseOf(valueOf("database") ?? DefaultDatabase);
        Host = HostOf(valueOf("host") ?? LocalHost);
        Port = valueOf("port") is string port ? PortOf(port) : null;
        Socket = SocketOf(valueOf("socket"));
        Tls = TlsSettings.Read(valueOf);
        if (Socket is not null && Tls.Mode is TlsMode.Required or TlsMode.VerifyIdentity)
        {
            throw new BadInputException(
                $"ssl options are for a server on the network, and this is the socket {Socket}. "
                + "Leave them out, or give the host by another name than localhost.");
        }
    }

    /// <summary>Path of the server's socket; null for a server on the network.</summary>
    public string? Socket { get; }

    /// <summary>The server's name; "localhost" if there is a socket.</summary>
    public string Host { get; }

    /// <summary>The server's port; null for the default one.</summary>
    public int? Port { get; }

    /// <summary>The database user.</summary>
    public string User { get; }

    /// <summary>The database of the tables.</summary>
    public string Database { get; }

    /// <summary>Encryption of the connection.</summary>
    public TlsSettings Tls { get; }

    /// <summary>Name of the server for messages: its socket, or host and port.</summary>
    public string Server => Socket ?? (Port is int port ? Invariant($"{Host}:{port}") : Host);

    /// <summary>Whether the server is on another computer and no option says whether to verify it.</summary>
    public bool IsUnverified => Socket is null && Tls.Mode == TlsMode.Default && Host != LocalHost
        && !(IPAddress.TryParse(Host, out IPAddress? address) && IPAddress.IsLoopback(address));

    /// <summary>Password for the connection; never part of a message.</summary>
    internal string Password { get; }

    /// <summary>
    /// Reads the settings from an option file, and those that it does not contain from the environment: MSISF_DB_HOST, _PORT, _SOCKET, ...,
    /// _SSL_CA.
    /// </summary>
    /// <param name="optionFile">Path of a file with a [client] group, as the mysql client reads; null if there is none.</param>
    /// <param name="environment">Gets a variable of the environment; null if it is not set.</param>
    /// <exception cref="BadInputException">The file or a value is wrong.</exception>
    /// <exception cref="UsageException">No user is given.</exception>
    public static DatabaseSettings Read(string? optionFile, Func<string, string?> environment)
    {
        IReadOnlyDictionary<string, string> file = optionFile is null
            ? new Dictionary<string, string>()
            : ClientOptionFile.Read(optionFile);
        return new DatabaseSettings(name =>
        {
            bool mayBeEmpty = name is "password" or "ssl-verify-server-cert";
            return file.TryGetValue(name, out string? value) && (value.Length > 0 || mayBeEmpty)
                ? value
                : environment($"MSISF_DB_{name.Replace('-', '_').ToUpperInvariant()}") is { Length: > 0 } variable ? variable : null;
        });
    }

    /// <summary>The first path that exists; the first of all if none exists.</summary>
    internal static string DefaultSocket(IReadOnlyList<string> places) => places.FirstOrDefault(File.Exists, places[0]);

    /// <summary>The socket of a host: localhost means the socket, as for the clients, except on Windows, which has none.</summary>
    private string? SocketOf(string? named)
    {
        if (named is not null)
        {
            if (named.Any(letter => letter == ';' || char.IsControl(letter)))
            {
                throw new BadInputException("database socket: no semicolon or control character can be in its path.");
            }

            return Host == LocalHost
                ? named
                : throw new BadInputException($"database host '{Host}' and socket '{named}' contradict each other. Leave one of them out.");
        }

        if (Host != LocalHost || OperatingSystem.IsWindows())
        {
            return null;
        }

        return Port is null
            ? DefaultSocket(DefaultSockets)
            : throw new BadInputException(Invariant(
                $"database port {Port}: localhost is the server's socket, which has no port. Give host=127.0.0.1, or leave the port out."));
    }

    private static string HostOf(string text) => HostName().IsMatch(text)
        ? text.Equals(LocalHost, StringComparison.OrdinalIgnoreCase) ? LocalHost : text
        : throw new BadInputException($"database host '{text}': the name or address of one host is needed.");

    private static int PortOf(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int port) && port is >= 1 and <= 65535
            ? port
            : throw new BadInputException($"database port '{text}': a number from 1 to 65535 is needed.");

    private static string DatabaseOf(string name) =>
        name.Length is >= 1 and <= 64 && name.All(letter => char.IsAsciiLetterOrDigit(letter) || letter == '_')
            ? name
            : throw new BadInputException($"database name '{name}': 1 to 64 letters, digits or '_' are needed.");

    [GeneratedRegex(@"\A[0-9A-Za-z_.:%-]{1,255}\z", RegexOptions.CultureInvariant)]
    private static partial Regex HostName();
}
