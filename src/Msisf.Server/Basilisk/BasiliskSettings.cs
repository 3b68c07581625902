using System.Text;
using System.Text.Json;
using Msisf.Adapters.Camera;
using Msisf.Adapters.Input;
using Msisf.App.Serving;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Scene;

namespace Msisf.Server.Basilisk;

/// <summary>How the images of simulations are drawn, where the messages do not say it.</summary>
internal sealed class BasiliskSettings : IDisposable
{
    public required IReadOnlyDictionary<long, CameraFile> Cameras { get; init; }

    /// <summary>Options of all images, as in a request.</summary>
    public required IReadOnlyDictionary<string, JsonElement> FrameOptions { get; init; }

    /// <summary>Where the Moon's attitude comes from.</summary>
    public required MoonAttitude MoonAttitude { get; init; }

    public StateRecord? Record { get; init; }

    /// <summary>Reads the files that the settings name, and tries the options.</summary>
    /// <exception cref="MsisfException">A file or an option is wrong.</exception>
    public static BasiliskSettings Read(ServeSettings settings, FrameService frames)
    {
        Dictionary<long, CameraFile> cameras = [];
        foreach ((string name, string path) in settings.BasiliskCameras)
        {
            CameraFile file = ServeOptions.BasiliskCameras.NamedInErrors(() => CameraFileReader.Read(path));
            cameras.Add(
                long.TryParse(name, NumberStyles.None, CultureInfo.InvariantCulture, out long id)
                    ? id
                    : throw ServeOptions.BasiliskCameras.Wrong($"{name}={path}: '{name}' is not a camera's number. Write 1={path}."),
                file with { Name = frames.Names.Add(file) });
        }

        Dictionary<string, JsonElement> options = settings.FrameOptions is { } optionsFile
            ? ReadOptions(optionsFile)
            : [];
        frames.Read(JsonSerializer.SerializeToElement(options, AnswerTypes.Default.DictionaryStringJsonElement), needsPlace: false);
        return new BasiliskSettings
        {
            Cameras = cameras,
            FrameOptions = options,
            MoonAttitude = settings.MoonAttitude,
            Record = settings.RecordFolder is { } folder ? new StateRecord(folder) : null,
        };
    }

    public void Dispose() => Record?.Dispose();

    private static Dictionary<string, JsonElement> ReadOptions(string path)
    {
        JsonElement json = FileErrors.ToBadInput(
            $"{ServeOptions.FrameOptions.Name} {path}: can't be read", () => ParseOptions(path));
        return JsonText.Members(json).ToDictionary(
            member => member.Key is not ("width" or "height" or "fov" or "camera")
                ? member.Key
                : throw new BadInputException(
                    $"{ServeOptions.FrameOptions.Name} {path}: '{member.Key}' is the simulation's. Remove it, or name a camera file with "
                        + $"{ServeOptions.BasiliskCameras.Name}."),
            member => member.Value,
            StringComparer.Ordinal);
    }

    private static JsonElement ParseOptions(string path)
    {
        try
        {
            return JsonText.Parse(Encoding.UTF8.GetBytes(File.ReadAllText(path)));
        }
        catch (JsonException exception)
        {
            throw new BadInputException($"{ServeOptions.FrameOptions.Name} {path}: is not JSON: {exception.Message}", exception);
        }
    }
}

/// <summary>
/// Writes the state of each image to a batch file, one for each camera, so that <c>msis --batch-file</c> draws the images again.
/// Thread-safe.
/// </summary>
internal sealed class StateRecord : IDisposable
{
    private readonly Lock _gate = new();
    private readonly string _folder;
    private readonly Dictionary<string, StreamWriter> _files = new(StringComparer.Ordinal);

    /// <param name="folder">The folder of the files; made if it is not there.</param>
    /// <exception cref="BadInputException">It can't be made.</exception>
    public StateRecord(string folder)
    {
        _folder = folder;
        FileErrors.ToBadInput(
            $"{ServeOptions.RecordFolder.Name} {folder}: can't be made", () => Directory.CreateDirectory(folder));
    }

    /// <param name="arguments">The canonical arguments of its images.</param>
    /// <param name="state">The state, with its Sun.</param>
    public void Add(long cameraId, Func<string> arguments, SpacecraftState state)
    {
        string name = Invariant($"camera-{cameraId}.csv");
        lock (_gate)
        {
            if (!_files.TryGetValue(name, out StreamWriter? file))
            {
                file = new StreamWriter(Path.Combine(_folder, name)) { NewLine = "\n", AutoFlush = true };
                _files.Add(name, file);
                string head = $"drawn again by: msis {arguments()} --batch-file {name}";
                using StringWriter first = new(CultureInfo.InvariantCulture) { NewLine = "\n" };
                BatchFileWriter.Write(first, head, [state]);
                file.Write(first);
                return;
            }

            using StringWriter text = new(CultureInfo.InvariantCulture) { NewLine = "\n" };
            BatchFileWriter.Write(text, string.Empty, [state]);
            file.WriteLine(text.ToString().TrimEnd('\n').Split('\n')[^1]);
        }
    }

    public void Dispose()
    {
        foreach (StreamWriter file in _files.Values)
        {
            file.Dispose();
        }
    }
}
