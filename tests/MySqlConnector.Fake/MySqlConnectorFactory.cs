using System.Data;
using System.Data.Common;

namespace MySqlConnector;

/// <summary>Makes sources whose database is <see cref="Answer"/>.</summary>
public sealed class MySqlConnectorFactory : DbProviderFactory
{
    public static readonly MySqlConnectorFactory Instance = new();

    private MySqlConnectorFactory()
    {
    }

    /// <summary>What a source of this factory answers.</summary>
    public Func<string, IReadOnlyDictionary<string, object>, DataTable> Answer { get; set; } = (_, _) => new DataTable();

    public override DbDataSource CreateDataSource(string connectionString) =>
        new FakeDataSource((text, parameters) => Answer(text, parameters), connectionString);
}
