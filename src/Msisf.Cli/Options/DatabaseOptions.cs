using System.CommandLine;

namespace Msisf.Cli.Options;

/// <summary>
/// Whether the samples come from a file or the database. There is no option for a password: arguments are seen by every user.
/// </summary>
internal sealed class DatabaseOptions
{
    public Option<string?> Source { get; } = OptionFactory.Value(
        "--source", [], "ldem|mysql",
        "Where the samples come from: an elevation model's file (default), or the database of scripts/ldem_mysql_insert.php");

    public Option<string?> DefaultsFile { get; } = OptionFactory.Value(
        "--defaults-file", [], "FILE",
        "With --source mysql: option file with the connection in its [client] group; "
            + "what it leaves out comes from MSISF_DB_HOST, _PORT, _SOCKET, _USER, _PASSWORD and _DATABASE");

    public IEnumerable<Option> All => [Source, DefaultsFile];
}
