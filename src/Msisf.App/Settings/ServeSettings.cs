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

    /// <summary>Catalogues of craters, by name.</summary>
    public IReadOnlyDictionary<string, string> Catalogues { get; init; } = new Dictionary<string, string>();
}
