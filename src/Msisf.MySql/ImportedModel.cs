using System.Data.Common;
using System.Text.RegularExpressions;

namespace Msisf.MySql;

/// <summary>Reads the import records of a table (docs/database.md) by the same rules as the PHP scripts.</summary>
internal static partial class ImportedModel
{
    private const int FormatVersion = 1;

    /// <summary>The product name of the model for its patterns; the parts of a model above 128 px/deg share the model's name.</summary>
    /// <param name="database">Database of the tables.</param>
    /// <exception cref="BadInputException">The import is missing or incomplete, or has parts of several models.</exception>
    /// <exception cref="ExternalPartException">The database failed.</exception>
    public static string ReadProductId(Database database, string table) => database.Query(
        "SELECT product_id, state, format_version, rows_done, row_count FROM ldem_import WHERE table_name = @table ORDER BY first_row, "
            + "first_col",
        [("@table", table)],
        reader => ProductId(reader, table));

    private static string ProductId(DbDataReader reader, string table)
    {
        List<string> names = [];
        while (reader.Read())
        {
            string product = reader.GetString(0);
            CheckWhole(reader, table, product);
            names.Add(PartOfModel().Replace(product, string.Empty));
        }

        string[] distinct = [.. names.Distinct(StringComparer.Ordinal)];
        return distinct switch
        {
            [] => throw new BadInputException(
                $"table {table}: no elevation model of this resolution is in the database. Import it with scripts/ldem_mysql_insert.php."),
            [string name] when ProperName().IsMatch(name) => name,
            [_] => throw new BadInputException(
                $"table {table}: the record of the import has a product without a proper name. Import it again."),
            _ => throw new BadInputException($"table {table}: it holds parts of several models ({string.Join(", ", distinct)}). "
                + $"Import each into a database of its own."),
        };
    }

    private static void CheckWhole(DbDataReader reader, string table, string product)
    {
        string state = reader.GetString(1);
        int format = Number(reader, 2);
        int done = Number(reader, 3);
        int all = Number(reader, 4);
        if (format != FormatVersion)
        {
            throw new BadInputException(Invariant(
                $"table {table}: {product} was imported in format {format}, this is {FormatVersion}. Import it again."));
        }

        if (state != "complete" || done != all)
        {
            throw new BadInputException(Invariant(
                $"table {table}: the import of {product} is not complete ({done} of {all} lines, state {state}). "
                    + $"Run scripts/ldem_mysql_insert.php again: it goes on where it stopped."));
        }
    }

    /// <summary>Reads a whole number. The columns are unsigned and of several widths, for which providers use different types.</summary>
    private static int Number(DbDataReader reader, int column) => Convert.ToInt32(reader.GetValue(column), CultureInfo.InvariantCulture);

    /// <summary>Matches the suffix in NASA's names for the parts of a model, e.g. LDEM_512_00N_45N_000_090.</summary>
    [GeneratedRegex(@"_\d{2}[NS]_\d{2}[NS]_\d{3}_\d{3}\z", RegexOptions.CultureInvariant)]
    private static partial Regex PartOfModel();

    [GeneratedRegex(@"\A[A-Za-z0-9_.-]{1,40}\z", RegexOptions.CultureInvariant)]
    private static partial Regex ProperName();
}
