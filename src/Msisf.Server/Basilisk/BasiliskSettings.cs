using System.Text;
using System.Text.Json;
using Msisf.Adapters.Camera;
using Msisf.App.Serving;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.Server.Basilisk;

/// <summary>How the images of simulations are drawn, where the messages do not say it.</summary>
internal sealed class BasiliskSettings : IDisposable
{
    /// <summary>The camera files, by the cameras' numbers.</summary>
    public required IReadOnlyDictionary<long, CameraFile> Cameras { get; init; }

    /// <summary>Options of all images, as in a request.</summary>
    public required IReadOnlyDictionary<string, JsonElement> FrameOptions { get; init; }

    /// <summary>Where the Moon's attitude comes from.</summary>
    public required MoonAttitude MoonAttitude { get; init; }

    /// <summary>Receives the states; null for none.</summary>
    public StateRecord? Record { get; init; }

    /// <summary>Reads the files that the settings name, and tries the options.</summary>
    /// <param name="frames">Reads the options.</param>
    /// <exception cref="MsisfException">A file or an option is wrong.</exception>
    public static BasiliskSettings Read(ServeSettings settings, FrameService frames)
    {
        Dictionary<long, CameraFile> cameras = [];
        foreach ((string name, string path) in settings.BasiliskCameras)
        {
            CameraFile file = ServeOptions.BasiliskCameras.NamedInErrors(() => CameraFileReader.Read(path));
            cameras.Add(
                long.TryParse(name, NumberStyles.None, CultureInfo.InvariantCulture, out long id) ? id : throw new UsageException(
                    $"{ServeOptions.BasiliskCameras.Name} {name}={path}: '{name}' is no camera's number. Write 1={path}.")
                    .About(ServeOptions.BasiliskCameras),
                file with { Name = frames.Names.Add(file) });
        }

        IReadOnlyDictionary<string, JsonElement> options = settings.FrameOptions is { } optionsFile
            ? ReadOptions(optionsFile)
            : new Dictionary<string, JsonElement>();
        frames.Read(JsonSerializer.SerializeToElement(options), needsPlace: false);
        return new BasiliskSettings
        {
            Cameras = cameras,
            FrameOptions = options,
            MoonAttitude = settings.MoonAttitude,
            Record = settings.RecordFolder is { } folder ? new StateRecord(folder) : null,
        };
    }

    /// <summary>Closes the record.</summary>
    public void Dispose() => Record?.Dispose();

    private static Dictionary<string, JsonElement> ReadOptions(string path)
    {
        using JsonDocument json = FileErrors.ToBadInput(
            $"{ServeOptions.FrameOptions.Name} {path}: can't be read", () => ParseOptions(path));
        return JsonText.Members(json.RootElement).ToDictionary(
            member => member.Key is not ("width" or "height" or "fov" or "camera")
                ? member.Key
                : throw new BadInputException(
                    $"{ServeOptions.FrameOptions.Name} {path}: '{member.Key}' is the simulation's. Remove it, or name a camera file with "
                        + $"{ServeOptions.BasiliskCameras.Name}."),
            member => member.Value.Clone(),
            StringComparer.Ordinal);
    }

    private static JsonDocument ParseOptions(string path)
    {
        try
        {
            return JsonText.Parse(Encoding.UTF8.GetBytes(File.ReadAllText(path)));
        }
        catch (JsonException exception)
        {
            throw new BadInputException($"{ServeOptions.FrameOptions.Name} {path}: is no JSON: {exception.Message}", exception);
        }
    }
}
