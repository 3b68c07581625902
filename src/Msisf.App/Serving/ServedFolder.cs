using Msisf.Adapters.Camera;
using Msisf.Adapters.Input;
using Msisf.Adapters.Manifest;
using Msisf.Adapters.Metadata;
using Msisf.App.Host;
using Msisf.App.Series;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Scene;

namespace Msisf.App.Serving;

/// <summary>The finished frames of an output folder. Read again when the folder's manifest has changed. Thread-safe.</summary>
/// <param name="names">Maps that the server has; a frame's map of another name is left out of its options.</param>
/// <param name="log">Receives warnings.</param>
internal sealed class ServedFolder(string folder, ServedNames names, ILog log)
{
    private static readonly (string Kind, string Ending)[] Kinds = [("image", ".png"), ("annotated", ".annotated.png"), ("meta", ".xml")];

    private static readonly Dictionary<string, OptionSpec> Known = CommandTable.OptionsOfRequest
        .Except([
            RendererOptions.Renderer, NativeOptions.Layers, OutputOptions.Grid, OutputOptions.GridHorizontal, OutputOptions.GridVertical,
            .. NavigationOptions.Group.Options,
        ])
        .ToDictionary(option => option.Key);

    private readonly Lock _gate = new();
    private (DateTime Written, long Length) _version;
    private IReadOnlyList<ServedFrame> _frames = [];

    /// <summary>The frames by their numbers; those without a meta file that says where the camera is are left out.</summary>
    /// <exception cref="MsisfException">The folder has no manifest.</exception>
    public IReadOnlyList<ServedFrame> Frames()
    {
        lock (_gate)
        {
            ManifestFile manifest = SeriesManifest.Find(folder);
            FileInfo file = new(manifest.FilePath);
            if (_version != (file.LastWriteTimeUtc, file.Length))
            {
                Dictionary<string, CameraFile?> cameras = new(StringComparer.Ordinal); // looked for once, not for each frame
                _frames = [.. SeriesManifest.Read(manifest, log).Frames.Values
                    .OrderBy(frame => frame.Step).ThenBy(frame => frame.Name, StringComparer.Ordinal)
                    .Select(frame => Read(frame, cameras)).OfType<ServedFrame>()];
                _version = (file.LastWriteTimeUtc, file.Length);
            }

            return _frames;
        }
    }

    private ServedFrame? Read(FrameRecord record, Dictionary<string, CameraFile?> cameras)
    {
        Dictionary<string, string> files = [];
        foreach ((string kind, string ending) in Kinds)
        {
            string name = record.Name + ending;
            if (record.Files.Any(file => file.Name == name))
            {
                files[kind] = Path.Combine(folder, name);
            }
        }

        Dictionary<string, string> options = files.TryGetValue("meta", out string? meta) ? Options(MetaFileCommand.Read(meta) ?? []) : [];
        return options.Remove(CameraOptions.FixedState.Key, out string? state) && StateOf(state) is { } known
            ? new ServedFrame(record.Step, known, options, files, CameraOf(options, cameras))
            : null;
    }

    /// <summary>A camera file lies with the frames, or where a run is usually started.</summary>
    private CameraFile? CameraOf(Dictionary<string, string> options, Dictionary<string, CameraFile?> cameras)
    {
        if (!options.TryGetValue(ImageOptions.Camera.Key, out string? name))
        {
            return null;
        }

        if (!cameras.TryGetValue(name, out CameraFile? camera))
        {
            camera = cameras[name] = names.FindCamera(name, [folder, Path.Combine(folder, ".."), ".", "input"]);
        }

        return camera;
    }

    private static SpacecraftState? StateOf(string text)
    {
        List<double> numbers = [];
        foreach (string word in text.Trim('{', '}').Split(','))
        {
            if (!NumberText.TryParse(word, out double number))
            {
                return null;
            }

            numbers.Add(number);
        }

        return numbers.Count == SpacecraftState.NumberNames.Count ? SpacecraftState.FromNumbers(numbers.ToArray()) : null;
    }

    /// <summary>The options of a command line that a request may have.</summary>
    private Dictionary<string, string> Options(IReadOnlyList<string> words)
    {
        Dictionary<string, string> options = [];
        for (int index = 0; index < words.Count; index++)
        {
            string key = words[index].TrimStart('-');
            if (!words[index].StartsWith("--", StringComparison.Ordinal) || !Known.TryGetValue(key, out OptionSpec? option))
            {
                continue;
            }

            string value = option is FlagSpec ? "true" : index + 1 < words.Count ? words[++index] : string.Empty;
            bool isMapElsewhere = option == AlbedoOptions.Map && value != AlbedoOptions.NoMap && !names.Maps.Contains(value.Split(',')[0]);
            if (!isMapElsewhere)
            {
                options[key] = options.TryGetValue(key, out string? before) ? before + PathSpec.Separator + value : value;
            }
        }

        return options;
    }
}
