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
