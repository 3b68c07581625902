using System.Net;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>The checked options of msis serve.</summary>
/// <param name="Listen">Where the server listens.</param>
/// <param name="Token">What clients must send; null for nothing.</param>
/// <param name="Certificate">Certificate and key for TLS, PEM files; null without TLS.</param>
/// <param name="Hosts">Names of the server beside localhost.</param>
/// <param name="MaxPixels">Pixels of the largest image.</param>
/// <param name="Queue">Number of requests that may wait.</param>
/// <param name="TimeLimit">Longest time of a request.</param>
/// <param name="Ldem">Elevation models, or folders of models; empty for those that a run finds.</param>
/// <param name="Kernels">SPICE meta-kernel in place of that of the installation, and kernels on top of it.</param>
internal sealed record ServeSettings(
    ListenAddress Listen, string? Token, (string Path, string Key)? Certificate, IReadOnlyList<string> Hosts, int MaxPixels, int Queue,
    TimeSpan TimeLimit, IReadOnlyList<string> Ldem, IReadOnlyList<string> Kernels)
{
    /// <summary>Megabytes of the largest answer.</summary>
    public required int MaxMegabytes { get; init; }

    /// <summary>Whether the server belongs to the program that started it: it ends with that, at once.</summary>
    public bool EndsWithInput { get; init; }

    /// <summary>Output folders and batch files of the viewer's time line, by name.</summary>
    public IReadOnlyDictionary<string, string> Folders { get; init; } = new Dictionary<string, string>();

    /// <summary>Where Basilisk finds the server, "tcp://ADDRESS:PORT"; null for a server of HTTP.</summary>
    public string? Basilisk { get; init; }

    /// <summary>Camera files for Basilisk's cameras, by their numbers.</summary>
    public IReadOnlyDictionary<string, string> BasiliskCameras { get; init; } = new Dictionary<string, string>();

    /// <summary>Where the Moon's attitude in a simulation of Basilisk comes from.</summary>
    public MoonAttitude MoonAttitude { get; init; }

    /// <summary>File with options of Basilisk's images; null for none.</summary>
    public string? FrameOptions { get; init; }

    /// <summary>Folder that receives the states of Basilisk's images; null for none.</summary>
    public string? RecordFolder { get; init; }

    /// <summary>Catalogues of craters, by name.</summary>
    public IReadOnlyDictionary<string, string> Catalogues { get; init; } = new Dictionary<string, string>();
}

/// <summary>Where the Moon's attitude in a simulation of Basilisk comes from.</summary>
internal enum MoonAttitude
{
    /// <summary>The message's rotation is taken as MOON_ME.</summary>
    Message,

    /// <summary>MOON_ME by the kernels at the time of the message.</summary>
    Spice,
}

/// <summary>Where a server listens.</summary>
/// <param name="EndPoint">Address and port; null for a Unix socket.</param>
/// <param name="SocketPath">Whole path of the Unix socket; null for an address.</param>
internal sealed record ListenAddress(IPEndPoint? EndPoint, string? SocketPath)
{
    /// <summary>Whether only this computer can reach it.</summary>
    public bool IsLocal => EndPoint is null || IPAddress.IsLoopback(EndPoint.Address);

    /// <summary>Reads ADDRESS:PORT, or the path of a Unix socket.</summary>
    /// <exception cref="BadInputException">The text is neither.</exception>
    public static ListenAddress Parse(string text)
    {
        if (text.Contains('/', StringComparison.Ordinal))
        {
            return new ListenAddress(null, Path.GetFullPath(text));
        }

        int colon = text.LastIndexOf(':');
        string host = colon < 0 ? text : text[..colon];
        string address = host == "localhost" ? IPAddress.Loopback.ToString() : host;
        return colon > 0
            && int.TryParse(text.AsSpan(colon + 1), NumberStyles.None, CultureInfo.InvariantCulture, out int port)
            && port <= IPEndPoint.MaxPort
            && (address.Contains(':', StringComparison.Ordinal) ? address is ['[', .., ']'] : address.Count(letter => letter == '.') == 3)
            && IPAddress.TryParse(address.Trim('[', ']'), out IPAddress? parsed)
                ? new ListenAddress(new IPEndPoint(parsed, port), null)
                : throw new BadInputException(
                    $"'{text}' is neither an address with a port, such as 127.0.0.1:8810 or [::1]:0, nor the path of a Unix socket, "
                        + "such as ./msis.sock.");
    }

    public override string ToString() => SocketPath ?? EndPoint!.ToString();
}

/// <summary>Files or folders under the names by which clients ask for them, so that no path of a request reaches the file system.</summary>
internal static class NamedPaths
{
    /// <summary>Reads a list such as "flight=runs/flight,craters.csv"; without a name the last part of the path is the name.</summary>
    /// <param name="option">The option that holds it.</param>
    /// <exception cref="UsageException">A path is empty, or two have one name.</exception>
    public static IReadOnlyDictionary<string, string> Read(TextSpec option, OptionValues values)
    {
        Dictionary<string, string> paths = new(StringComparer.Ordinal);
        foreach (string entry in option.ReadIfGiven(values)?.Split(option.Separator!, StringSplitOptions.TrimEntries) ?? [])
        {
            string[] parts = entry.Split('=', 2);
            string path = Path.GetFullPath(parts[^1].Length > 0 ? parts[^1] : throw Wrong("is a path"));
            string name = parts.Length == 2 ? parts[0] : Path.GetFileName(Path.TrimEndingDirectorySeparator(path));
            if (name.Length == 0 || name.Contains('/', StringComparison.Ordinal) || !paths.TryAdd(name, path))
            {
                throw Wrong($"has a name of its own without '/', but '{name}' is none");
            }

            UsageException Wrong(string needed) =>
                option.Wrong($"{entry}: each part {needed}. Write NAME=PATH, separated by commas.");
        }

        return paths;
    }
}

/// <summary>
/// The options of msis serve as msis hands them to the server's program: one word "--name=value" for each option that is given, so that
/// the program needs no parser of its own.
/// </summary>
internal static class ServeArguments
{
    public static IReadOnlyList<string> ToWords(OptionValues values) =>
        [.. CommandTable.Serve.Options.SelectMany(option => Words(option, values))];

    private static IEnumerable<string> Words(OptionSpec option, OptionValues values)
    {
        if (values.Words(option) is not { } words)
        {
            return [];
        }

        return option.MayBeRepeated ? words.Select(word => $"{option.Name}={word}") : [$"{option.Name}={values.Text(option)}"];
    }

    /// <summary>The options of the words of <see cref="ToWords"/>.</summary>
    public static OptionValues FromWords(IEnumerable<string> words) => new(words.Select(word => word.Split('=', 2))
        .GroupBy(pair => pair[0], pair => pair[^1])
        .Select(option => KeyValuePair.Create(option.Key, new OptionValue([.. option]))));
}
