using System.Data.Common;

namespace Msisf.MySql;

/// <summary>Shortens what ADO.NET needs four lines for.</summary>
internal static class DbCommandExtensions
{
    /// <summary>Adds a parameter with its value.</summary>
    public static void AddValue(this DbCommand command, string name, object value)
    {
        DbParameter parameter = command.CreateParameter();
        parameter.ParameterName = name;
        parameter.Value = value;
        command.Parameters.Add(parameter);
    }
}
