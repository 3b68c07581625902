using System.Data;
using System.Data.Common;

namespace MySqlConnector;

/// <summary>Makes sources of an empty database, if the socket that they name is there.</summary>
public sealed class MySqlConnectorFactory : DbProviderFactory
{
    public static readonly MySqlConnectorFactory Instance = new();

    private MySqlConnectorFactory()
    {
    }

    public override DbDataSource CreateDataSource(string connectionString)
    {
        DbConnectionStringBuilder parts = new() { ConnectionString = connectionString };
        return parts.ContainsKey("Connection Protocol") && !File.Exists((string)parts["Server"])
            ? throw new MySqlException(0, $"Cannot find Unix Socket at {parts["Server"]}")
            : new FakeDataSource((_, _) => new DataTable(), connectionString);
    }
}
