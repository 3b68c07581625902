using System.Data.Common;
using System.Globalization;
using System.Reflection;
using Msisf.Core.Errors;

namespace Msisf.MySql;

/// <summary>
/// Loads the provider of connections to MySQL and MariaDB. Only this class names the package MySqlConnector. Not every package registry has
/// it, so the build puts it into a folder beside the program if it can be restored, and it is loaded from there when needed.
/// </summary>
internal static class MySqlProvider
{
    private const string Library = "MySqlConnector.dll";
    private const string Factory = "MySqlConnector.MySqlConnectorFactory";

    /// <summary>
    /// Idle time, s, up to which a pooled connection is used without testing it; servers close idle connections only after hours.
    /// </summary>
    private const string IdlePingSeconds = "30";

    /// <summary>Loads the package.</summary>
    /// <param name="folder">Folder of the package's files.</param>
    /// <exception cref="ExternalPartException">This build does not contain the package, or its files are damaged.</exception>
    public static DbProviderFactory Load(string folder)
    {
        string path = Path.GetFullPath(Path.Combine(folder, Library));
        if (!File.Exists(path))
        {
            throw new ExternalPartException(
                $"this build of msis has no MySqlConnector ({path} is missing), so it can't read a database. "
                    + $"Use scripts/generate_pattern.php, or run scripts/build.sh where the package MySqlConnector can be restored.");
        }

        try
        {
            return Assembly.LoadFrom(path).GetType(Factory)?.GetField("Instance")?.GetValue(null) as DbProviderFactory
                ?? throw new TypeLoadException($"it has no {Factory}");
        }
        catch (Exception exception)
        {
            throw DatabaseFailure.OfProvider(exception, path);
        }
    }

    /// <summary>The connection string of the provider for some settings.</summary>
    /// <remarks>No statement changes a session's state, so a pooled connection is used without the two statements that reset it.</remarks>
    public static string ConnectionString(DatabaseSettings settings)
    {
        DbConnectionStringBuilder builder = new()
        {
            ["Server"] = settings.Socket ?? settings.Host,
            ["User ID"] = settings.User,
            ["Password"] = settings.Password,
            ["Database"] = settings.Database,
            ["Connection Reset"] = "false",
            ["Connection Idle Ping Time"] = IdlePingSeconds,
        };
        if (settings.Socket is not null)
        {
            builder["Connection Protocol"] = "Unix";
        }
        else if (settings.Port is int port)
        {
            builder["Port"] = port.ToString(CultureInfo.InvariantCulture);
        }

        if (settings.Tls.Mode != TlsMode.Default)
        {
            builder["SSL Mode"] = settings.Tls.Mode switch
            {
                TlsMode.Disabled => "None",
                TlsMode.Required => "Required",
                _ => "VerifyFull",
            };
        }

        if (settings.Tls.CertificateAuthority is string authority)
        {
            builder["SslCa"] = Path.GetFullPath(authority);
        }

        return builder.ConnectionString;
    }
}
