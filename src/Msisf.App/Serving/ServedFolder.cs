using Msisf.Adapters.Camera;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Input;
using Msisf.Adapters.Manifest;
using Msisf.Adapters.Metadata;
using Msisf.Adapters.Trajectories;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Series;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Attitude;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.App.Serving;

/// <summary>The finished frames of an output folder. Read again when the folder's manifest has changed. Thread-safe.</summary>
/// <param name="names">Maps that the server has; a frame's map of another name is left out of its options.</param>
internal sealed class ServedFolder(string folder, ServedNames names, Func<TimeScale> scale, ILog log)
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

        Dictionary<string, string> options = files.TryGetValue("meta", out string? meta) ? Options(MetaFileOrigin.Command(meta) ?? []) : [];
        return options.Remove(CameraOptions.FixedState.Key, out string? state) && StateOf(state, scale()) is { } known
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

    private static SpacecraftState? StateOf(string text, TimeScale scale)
    {
        try
        {
            (CalendarTime time, double[] numbers) = StateText.ParseState(
                CameraOptions.FixedState.Name, [text], SpacecraftState.NumberNames);
            return SpacecraftState.FromNumbers(scale.InstantOf(time), numbers);
        }
        catch (BadInputException)
        {
            return null;
        }
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

/// <summary>The states of a batch file or of a trajectory (OEM), for the viewer's time line.</summary>
internal static class ServedBatch
{
    /// <summary>Frames of a trajectory, which has states at all times.</summary>
    private const double MostFrames = 1000.0;

    private const double LeastStep = 1.0; // s

    /// <summary>Reads the states as a run does; named columns may need the terrain.</summary>
    /// <param name="requested">Options, and the model whose terrain it is.</param>
    /// <param name="ephemeris">Where the Sun is, for cameras that are pointed by it.</param>
    /// <exception cref="MsisfException">The file is wrong.</exception>
    public static IReadOnlyList<ServedFrame> Frames(
        string path, RequestedFrame requested, ServedEphemeris ephemeris, ProgramHost host, CancellationToken cancellation)
    {
        RunGeometry geometry = new(
            () => requested.Model.Opened, () => ephemeris.Of(requested.Settings).Engine(),
            () => ephemeris.Of(requested.Settings).TimeScale(), requested.Settings.Aberration);
        StateReader reader = new(() => ephemeris.Of(requested.Settings).Engine(), geometry, host)
        {
            Kernels = () => ephemeris.Of(requested.Settings).Kernels(),
        };
        TrajectorySettings trajectory = TrajectoryFile.IsOne(path)
            ? OfTrajectory(path, () => ephemeris.Of(requested.Settings).Kernels(), geometry)
            : new BatchFileSettings(path, CameraOptions.BatchFile);
        return [.. reader.Read(trajectory, cancellation).Select(
            (state, index) => new ServedFrame(
                index + 1, state with { Motion = null }, new Dictionary<string, string>(), new Dictionary<string, string>()))];
    }

    /// <summary>Evenly over the file's cover, the nadir in the middle.</summary>
    private static MissionSettings OfTrajectory(string path, Func<OpenedEphemeris> kernels, RunGeometry geometry)
    {
        MissionSettings settings = new(
            new FilePosition(path, MissionOptions.Oem), new PointedChoice(new CameraPointing()), Times: null, LeastStep);
        double seconds = MissionPath.Open(settings, kernels(), geometry, _ => { }).Path.Cover.Intervals.Sum(
            interval => interval.End - interval.Start);
        return settings with { Every = Math.Max(LeastStep, seconds / MostFrames) };
    }
}

/// <summary>A frame on the viewer's time line.</summary>
/// <param name="Number">From 1.</param>
/// <param name="State">Where and when.</param>
/// <param name="Options">Its other options as a request has them, by their names without dashes.</param>
/// <param name="Files">Paths of its stored files by kind: image, annotated, meta; none for a line of a batch file.</param>
/// <param name="Camera">The camera that its options name; null if they name none, or one that was not found.</param>
internal sealed record ServedFrame(
    int Number, SpacecraftState State, IReadOnlyDictionary<string, string> Options, IReadOnlyDictionary<string, string> Files,
    CameraFile? Camera = null);
