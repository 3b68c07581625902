using System.Reflection;
using Msisf.Adapters.IO;
using Msisf.Adapters.Raster.Heights;

namespace Msisf.App.Host;

/// <summary>
/// The environment of the application: outputs, log, clock, environment variables and the program's own files. Tests provide their own.
/// </summary>
internal sealed class ProgramHost
{
    private const string Name = "msisf";

    /// <summary>Windows has one folder for data and cache; a map's cache is not a map.</summary>
    private const string CacheOnWindows = "cache";

    private readonly Lazy<Installation> _installation = new(() => Installation.Above(AppContext.BaseDirectory));
    private readonly Func<string, string?> _environment;
    private readonly Lazy<GeoTiffFiles> _geoTiffs;

    public ProgramHost(TimeProvider clock, Func<string, string?> environment)
    {
        _environment = environment;
        Clock = clock;
        Times = new RunTimes(clock);
        _geoTiffs = new Lazy<GeoTiffFiles>(() => new GeoTiffFiles(Environment("MSISF_GDAL")));
    }

    public required TextWriter Results { get; init; }

    public required ILog Log { get; init; }

    public required IProgressDisplay Progress { get; init; }

    public required Func<TextReader> StandardInput { get; init; }

    /// <summary>Whether this program is that of the server too.</summary>
    public bool HoldsServer { get; init; }

    public TimeProvider Clock { get; }

    public RunTimes Times { get; }

    public string Version { get; } =
        typeof(ProgramHost).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()!.InformationalVersion;

    /// <summary>Opens elevation models in GeoTIFF, each once.</summary>
    public GeoTiffFiles GeoTiffs => _geoTiffs.Value;

    public Installation Installation => _installation.Value;

    /// <summary>Folder for files that can be made again and have no other place; null if no variable says where it is.</summary>
    public string? CacheFolder => UserFolder("XDG_CACHE_HOME", "LOCALAPPDATA", ".cache", CacheOnWindows);

    /// <summary>Folder of the user's settings; null if no variable says where it is.</summary>
    public string? ConfigFolder => UserFolder("XDG_CONFIG_HOME", "APPDATA", ".config");

    /// <summary>Folder of the user's data of this program; null if no variable says where it is.</summary>
    public string? DataFolder => UserFolder("XDG_DATA_HOME", "LOCALAPPDATA", Path.Combine(".local", "share"));

    /// <summary>Gets a variable of the environment; null if it is not set or empty.</summary>
    public string? Environment(string name) => _environment(name) is { Length: > 0 } value ? value : null;

    /// <summary>The program's folder below that of a variable, of one of Windows, or of $HOME.</summary>
    private string? UserFolder(string variable, string ofWindows, string belowHome, string belowWindows = "") =>
        Environment(variable) is { } named ? Path.Combine(named, Name)
        : Environment(ofWindows) is { } local ? Path.Combine(local, Name, belowWindows)
        : Environment("HOME") is { } home ? Path.Combine(home, belowHome, Name)
        : null;
}
