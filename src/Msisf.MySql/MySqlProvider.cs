using System.Data.Common;
using System.Globalization;
using System.Reflection;
using Msisf.Core.Errors;

namespace Msisf.MySql;

/// <summary>
/// The provider of connections to MySQL and MariaDB. The one place that names the package MySqlConnector: it is not in every registry, so
/// it is looked for when it is needed, in a folder of its own beside the program; the build puts it there where the package restores.
/// </summary>
internal static class MySqlProvider
{
    private const string Library = "MySqlConnector.dll";
    private const string Factory = "MySqlConnector.MySqlConnectorFactory";

    /// <summary>Connections that lie in the pool for no longer than this are taken to be open, s; a server ends them after hours.</summary>
    private const string IdlePingSeconds = "30";

    /// <summary>Loads the package.</summary>
    /// <param name="folder">Folder of the package's files.</param>
    /// <exception cref="ExternalPartException">This build is without the package, or its files are damaged.</exception>
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

    /// <summary>The settings in the words of the provider.</summary>
    /// <remarks>
    /// No statement changes a session's state, so a connection from the pool is used as it is, without the two statements that reset it.
    /// </remarks>
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
