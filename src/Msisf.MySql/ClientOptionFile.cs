using System.Text.RegularExpressions;

namespace Msisf.MySql;

/// <summary>Reads the [client] group of an option file of the MySQL and MariaDB clients. Messages never contain a value.</summary>
internal static partial class ClientOptionFile
{
    private const UnixFileMode OfOthers = UnixFileMode.GroupRead | UnixFileMode.GroupWrite | UnixFileMode.GroupExecute
        | UnixFileMode.OtherRead | UnixFileMode.OtherWrite | UnixFileMode.OtherExecute;

    private static readonly string[] Tls = ["ssl-ca", "ssl-mode", "ssl-verify-server-cert"];

    private static string Supported => $"host, port, socket, {string.Join(", ", Tls)}";

    /// <summary>Reads the options of the group by name, with "-" between words.</summary>
    /// <exception cref="BadInputException">
    /// The file can't be read, other users can read its password, a line is not an option, or an option that changes the connection is
    /// not supported.
    /// </exception>
    public static IReadOnlyDictionary<string, string> Read(string path)
    {
        return FileErrors.ToBadInput($"{path}: this option file is missing or can't be read", () =>
        {
            Dictionary<string, string> options = Parse(File.ReadAllLines(path), path);
            return options.ContainsKey("password") && !OperatingSystem.IsWindows() && (File.GetUnixFileMode(path) & OfOthers) != 0
                ? throw new BadInputException($"{path}: holds a password, and other users may read it. Say: chmod 600 on it.")
                : options;
        });
    }

    private static Dictionary<string, string> Parse(string[] lines, string path)
    {
        Dictionary<string, string> options = [];
        bool isClient = false;
        for (int i = 0; i < lines.Length; i++)
        {
            string line = lines[i].Trim();
            if (line.Length == 0 || line[0] is '#' or ';')
            {
                continue;
            }

            if (line[0] == '[' && line[^1] == ']')
            {
                isClient = line == "[client]";
            }
            else if (Option().Match(line) is { Success: true } option)
            {
                if (isClient)
                {
                    string name = option.Groups["name"].Value.Replace('_', '-');
                    options[name] = Unquoted(option.Groups["value"].Value);
                    if (OfConnection().IsMatch(name) && !Tls.Contains(name))
                    {
                        throw new BadInputException(Invariant(
                            $"{path}, line {i + 1}: the option {name} is not supported here. "
                                + $"Leave it out; {Supported} say how to connect."));
                    }
                }
            }
            else
            {
                throw new BadInputException(Invariant(
                    $"{path}, line {i + 1}: neither [group] nor name=value. Keep the connection in a file of its own, without !include."));
            }
        }

        return options;
    }

    /// <summary>
    /// Removes quotes, comments and escapes from a value by the rules of the clients: quotes around a value are removed, " #" outside
    /// quotes begins a comment, backslashes escape.
    /// </summary>
    private static string Unquoted(string value)
    {
        Match quoted = Quoted().Match(value);
        string text = quoted.Success ? quoted.Groups["text"].Value : Comment().Replace(value, string.Empty).TrimEnd();
        return Escape().Replace(text, match => match.Value[1] switch
        {
            'b' => "\b",
            't' => "\t",
            'n' => "\n",
            'r' => "\r",
            's' => " ",
            char other => other.ToString(),
        });
    }

    [GeneratedRegex(@"\A(?<name>[0-9A-Za-z_-]+)\s*(?:=\s*(?<value>.*))?\z", RegexOptions.CultureInvariant)]
    private static partial Regex Option();

    /// <summary>
    /// Matches options that change the connection: ignoring one could connect to another server, or to one that is not verified.
    /// </summary>
    [GeneratedRegex(@"\Aprotocol\z|(?:\A|-)(?:ssl|tls)(?:-|\z)", RegexOptions.CultureInvariant | RegexOptions.IgnoreCase)]
    private static partial Regex OfConnection();

    [GeneratedRegex("""\A(?<quote>["'])(?<text>(?:\\.|(?!\k<quote>)[^\\])*)\k<quote>(?:\s*#.*)?\z""", RegexOptions.CultureInvariant)]
    private static partial Regex Quoted();

    [GeneratedRegex(@"\s#.*\z", RegexOptions.CultureInvariant)]
    private static partial Regex Comment();

    [GeneratedRegex("""\\[btnr\\s"']""", RegexOptions.CultureInvariant)]
    private static partial Regex Escape();
}
