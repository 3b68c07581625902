using System.Collections;
using System.Data.Common;

namespace MySqlConnector;

/// <summary>What the package throws when the server refuses, or can't be reached.</summary>
public sealed class MySqlException(int number, string message, Exception? inner = null) : DbException(message, inner)
{
    public int Number => number;

    public override IDictionary Data { get; } = new Hashtable { ["Server Error Code"] = number };
}
