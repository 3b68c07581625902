using MySqlConnector;

namespace Msisf.MySql;

/// <summary>The connection string of some settings.</summary>
internal static class ConnectionText
{
    /// <summary>The connection string of some settings.</summary>
    /// <remarks>No statement changes a session's state, so a pooled connection is used without the two statements that reset it.</remarks>
    public static string Of(DatabaseSettings settings)
    {
        MySqlConnectionStringBuilder builder = new()
        {
            Server = settings.Socket ?? settings.Host,
            UserID = settings.User,
            Password = settings.Password,
            Database = settings.Database,
            ConnectionReset = false,
            ConnectionProtocol = settings.Socket is null ? MySqlConnectionProtocol.Socket : MySqlConnectionProtocol.UnixSocket,
            SslMode = settings.Tls.Mode switch
            {
                TlsMode.Default => MySqlSslMode.Preferred,
                TlsMode.Disabled => MySqlSslMode.Disabled,
                TlsMode.Required => MySqlSslMode.Required,
                _ => MySqlSslMode.VerifyFull,
            },
        };
        if (settings.Port is int port)
        {
            builder.Port = (uint)port;
        }

        if (settings.Tls.CertificateAuthority is string authority)
        {
            builder.SslCa = Path.GetFullPath(authority);
        }

        return builder.ConnectionString;
    }
}
