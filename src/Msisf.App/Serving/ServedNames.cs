using System.Collections.Concurrent;
using Msisf.Adapters.Camera;
using Msisf.Adapters.Input;
using Msisf.Adapters.Raster.Albedo;
using Msisf.Adapters.Trajectories;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Orbit;

namespace Msisf.App.Serving;

/// <summary>
/// The files that a request may ask for, by name: elevation models, maps and cameras. They are looked for once, so that no path of a
/// request reaches the file system.
/// </summary>
internal sealed class ServedNames : IDisposable
{
    private readonly Dictionary<string, string> _maps;
    private readonly IReadOnlyDictionary<string, string> _catalogues;
    private readonly IReadOnlyDictionary<string, string> _folders;
    private readonly Action<string> _note;
    private readonly ConcurrentDictionary<string, IReadOnlyList<TrajectoryBlock>> _trajectories = new(StringComparer.Ordinal);
    private readonly ConcurrentDictionary<string, CameraFile> _cameraFiles = new(StringComparer.Ordinal);

    /// <summary>Looks for the files.</summary>
    /// <exception cref="BadInputException">There is no elevation model.</exception>
    public ServedNames(ServeSettings settings, ProgramHost host)
    {
        Models = new ServedModels(settings.Ldem, host);
        _maps = new Dictionary<string, string>(StringComparer.Ordinal);
        foreach (string path in AlbedoSource.Maps(host))
        {
            _maps.TryAdd(Path.GetFileName(path), path);
        }

        (_catalogues, _folders, _note) = (settings.Catalogues, settings.Folders, host.Log.Note);
        Cameras = CameraChoice.Presets(host.Installation);
    }

    public ServedModels Models { get; }

    /// <summary>Names of the maps of the Moon's reflectance and of Hapke's parameters.</summary>
    public IReadOnlyCollection<string> Maps => _maps.Keys;

    public IReadOnlyList<CameraFile> Cameras { get; }

    /// <summary>The model of a resolution, px/deg.</summary>
    public ServedModel Model(int pixelsPerDegree) => Models.All.FirstOrDefault(
        model => model.IsWholeMoon && model.Resolution.PixelsPerDegree == pixelsPerDegree)
        ?? throw SurfaceOptions.Resolution.Wrong(
            $"is {pixelsPerDegree}; the server has "
                + $"{string.Join(", ", Models.All.Where(model => model.IsWholeMoon).Select(model => model.Resolution.PixelsPerDegree))} "
                + "(/v1/models).");

    /// <param name="option">Key of the option, for the message.</param>
    /// <param name="name">Name of the map; "none" is kept.</param>
    public string Map(string option, string name) => name == AlbedoOptions.NoMap ? name
        : _maps.TryGetValue(name, out string? path) ? path : throw Unknown(option, name, _maps.Keys);

    /// <summary>The text of a map of the reflectance with its path in place of its name.</summary>
    public string AlbedoMap(string option, AlbedoMapPath named) => named.TextWith(Map(option, named.Path));

    /// <summary>The path of a catalogue of craters or stars, or of a list of landmarks.</summary>
    /// <param name="option">Key of the option, for the message.</param>
    public string Catalogue(string option, string name) =>
        _catalogues.TryGetValue(name, out string? path) ? path : throw Unknown(option, name, _catalogues.Keys);

    /// <summary>The trajectory of a name of <c>--folders</c>; its file is read once, when it is first needed.</summary>
    public SampledPosition Trajectory(string name) => _folders.TryGetValue(name, out string? path) && !Directory.Exists(path)
        ? new SampledPosition(name, kernels => _trajectories.GetOrAdd(
            name, _ => FileErrors.ToBadInput(
                $"{name}: can't be read", () => TrajectoryFile.Read(path, name, kernels, _note))))
        : throw new UsageException(
            $"'{RequestStates.Key}' is {NumberText.Shown(name)}, which is not a trajectory of this server; GET /v1/folders lists them, and "
                + "--folders names them.");

    /// <summary>The preset of a name, or the camera file of a served folder as its frames name it.</summary>
    public CameraFile Camera(string name) => KnownCamera(name)
        ?? throw Unknown("camera", name, Cameras.Select(camera => camera.Name));

    /// <summary>Looks for the camera of a folder's frames, so that requests may name it.</summary>
    /// <param name="name">As the arguments of the frames name it.</param>
    /// <param name="folders">Where its file may be.</param>
    /// <returns>The camera; null if there is no such preset and no such file.</returns>
    public CameraFile? FindCamera(string name, IEnumerable<string> folders) =>
        KnownCamera(name) ?? (CameraChoice.Find(name, folders) is { } found ? _cameraFiles.GetOrAdd(name, found) : null);

    /// <summary>Lets requests name a camera of the server's own.</summary>
    /// <returns>Its name, with which no file of a folder begins.</returns>
    public string Add(CameraFile camera)
    {
        string name = $"/{camera.Name}#{camera.Sha256}";
        _cameraFiles[name] = camera;
        return name;
    }

    public void Dispose() => Models.Dispose();

    private CameraFile? KnownCamera(string name) =>
        Cameras.FirstOrDefault(camera => IsSame(camera.Name, name)) ?? _cameraFiles.GetValueOrDefault(name);

    private static bool IsSame(string one, string other) => one.Equals(other, StringComparison.OrdinalIgnoreCase);

    /// <summary>The error that there is no file of a name.</summary>
    internal static UsageException Unknown(string what, string name, IEnumerable<string> names) => new(
        $"'{what}' is {NumberText.Shown(name)}, which the server does not have{NearestName.Question(name, [.. names], ".")} "
            + "GET /v1/models lists all names.");
}
