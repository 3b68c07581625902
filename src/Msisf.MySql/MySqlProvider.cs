using System.Data.Common;
using System.Globalization;
using System.Reflection;
using Msisf.Core.Errors;

namespace Msisf.MySql;

/// <summary>
/// Connects to MySQL and MariaDB. Only this class names the package MySqlConnector: not every registry has it, so it is loaded when it is
/// needed, from a folder of its own beside the program, into which the build puts it where the package restores.
/// </summary>
public static class MySqlProvider
{
    private const string Library = "MySqlConnector.dll";
    private const string Factory = "MySqlConnector.MySqlConnectorFactory";

    /// <summary>A source of connections. It does not connect yet.</summary>
    /// <param name="settings">Where the database is.</param>
    /// <param name="folder">Folder of the package's files.</param>
    /// <exception cref="ExternalPartException">This build is without the package.</exception>
    public static DbDataSource Open(DatabaseSettings settings, string folder)
    {
        string path = Path.GetFullPath(Path.Combine(folder, Library));
        if (!File.Exists(path))
        {
            throw new ExternalPartException(
                $"this build of msis has no MySqlConnector ({path} is missing), so it can't read a database. "
                    + $"Use scripts/generate_pattern.php, or build where the package MySqlConnector can be restored.");
        }

        object? factory = Assembly.LoadFrom(path).GetType(Factory)?.GetField("Instance")?.GetValue(null);
        return factory is DbProviderFactory provider
            ? provider.CreateDataSource(ConnectionString(settings))
            : throw new ExternalPartException($"{path}: has no {Factory}; another version of MySqlConnector is needed. Build msis again.");
    }

    private static string ConnectionString(DatabaseSettings settings)
    {
        DbConnectionStringBuilder builder = new()
        {
            ["Server"] = settings.Socket ?? settings.Host,
            ["User ID"] = settings.User,
            ["Password"] = settings.Password,
            ["Database"] = settings.Database,
        };
        if (settings.Socket is not null)
        {
            builder["Connection Protocol"] = "Unix";
        }
        else if (settings.Port is int port)
        {
            builder["Port"] = port.ToString(CultureInfo.InvariantCulture);
        }

        return builder.ConnectionString;
    }
}
