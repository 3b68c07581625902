using System.Globalization;
using Msisf.Core.Errors;

namespace Msisf.MySql;

/// <summary>The database and its user, as for the PHP scripts. The password is in no message.</summary>
public sealed class DatabaseSettings
{
    private const string DefaultDatabase = "msisf";

    private DatabaseSettings(Func<string, string?> valueOf)
    {
        Socket = valueOf("socket");
        Host = valueOf("host") ?? "localhost";
        Port = valueOf("port") is string port ? PortOf(port) : null;
        User = valueOf("user") ?? throw new UsageException(
            "no database user. Give --defaults-file FILE with a [client] group, or set MSISF_DB_USER and MSISF_DB_PASSWORD.");
        Password = valueOf("password") ?? string.Empty;
        Database = DatabaseOf(valueOf("database") ?? DefaultDatabase);
    }

    /// <summary>Path of the server's socket; null for a server on the network.</summary>
    public string? Socket { get; }

    /// <summary>The server's name; not used if there is a socket.</summary>
    public string Host { get; }

    /// <summary>The server's port; null for the default one.</summary>
    public int? Port { get; }

    /// <summary>The database user.</summary>
    public string User { get; }

    /// <summary>The database of the tables.</summary>
    public string Database { get; }

    /// <summary>For the connection, never for a message.</summary>
    internal string Password { get; }

    /// <summary>Reads the option file. What it leaves out comes from MSISF_DB_HOST, _PORT, _SOCKET, _USER, _PASSWORD, _DATABASE.</summary>
    /// <param name="optionFile">Path of a file with a [client] group, as the mysql client reads; null if there is none.</param>
    /// <param name="environment">Gives a variable of the environment; null if it is not set.</param>
    /// <exception cref="BadInputException">The file or a value is wrong.</exception>
    /// <exception cref="UsageException">Nothing names a user.</exception>
    public static DatabaseSettings Read(string? optionFile, Func<string, string?> environment)
    {
        IReadOnlyDictionary<string, string> file = optionFile is null
            ? new Dictionary<string, string>()
            : ClientOptionFile.Read(optionFile);
        return new DatabaseSettings(
            name => file.TryGetValue(name, out string? value) ? value : environment($"MSISF_DB_{name.ToUpperInvariant()}"));
    }

    private static int PortOf(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int port) && port is >= 1 and <= 65535
            ? port
            : throw new BadInputException($"database port '{text}': a number from 1 to 65535 is needed.");

    private static string DatabaseOf(string name) =>
        name.Length is >= 1 and <= 64 && name.All(letter => char.IsAsciiLetterOrDigit(letter) || letter == '_')
            ? name
            : throw new BadInputException($"database name '{name}': 1 to 64 letters, digits or '_' are needed.");
}
