using System.Text;
using System.Text.Json;
using Msisf.Adapters.Camera;
using Msisf.Adapters.Input;
using Msisf.Adapters.Raster.Albedo;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Orbit;
using Msisf.Core.Render;

namespace Msisf.App.Serving;

/// <summary>
/// Reads a frame's options from JSON: keys are the names of the command line without dashes, values what would be typed there, lists as
/// arrays and flags as true or false. Beside them there are "model" and "states", "camera" may be an object with the keys of a camera file,
/// and "trajectory" and "jitter" are lists of what is in the lines of their files.
/// </summary>
internal sealed class JsonOptions
{
    /// <summary>Key of the elevation model, which is a name of the server's.</summary>
    public const string ModelKey = "model";

    /// <summary>Name of a camera that the request itself describes.</summary>
    private const string InlineCamera = "camera";

    private static readonly Dictionary<string, OptionSpec> Allowed = CommandTable.OptionsOfRequest.ToDictionary(
        option => option.Key, StringComparer.Ordinal);

    private static readonly string[] Ways =
    [
        CameraOptions.FixedState.Key, CameraOptions.KeplerSet.Key, CameraOptions.StateVectors.Key, PointingOptions.Position.Key,
        RequestStates.Key, ScanOptions.Trajectory.Key,
    ];

    private readonly ServedNames _names;
    private readonly Dictionary<string, OptionValue> _values = new(StringComparer.Ordinal);
    private ServedModel? _model;
    private JsonElement? _states;
    private JitterFile? _jitter;
    private string? _samples;
    private CameraFile? _camera;

    private JsonOptions(ServedNames names, ServeSettings settings)
    {
        _names = names;
        _values[RendererOptions.Renderer.Name] = new OptionValue([RendererOptions.Renderer.WordOf(RendererKind.Native)]);
        if (settings.Kernels.Count > 0)
        {
            _values[LightOptions.Kernels.Name] = new OptionValue(settings.Kernels);
        }
    }

    /// <summary>Reads the options.</summary>
    /// <param name="given">The members of the object with the options.</param>
    /// <param name="changes">Options that replace those; null for none.</param>
    /// <param name="needsPlace">Whether the options must say where the camera is.</param>
    /// <param name="names">The files that may be named.</param>
    /// <param name="isOfSeveral">Whether other cameras have the options too, as with a rig file.</param>
    /// <exception cref="MsisfException">An option is unknown, not allowed, or wrong.</exception>
    public static RequestedFrame Read(
        IReadOnlyDictionary<string, JsonElement> given, IReadOnlyDictionary<string, JsonElement>? changes, bool needsPlace,
        ServedNames names, ServeSettings settings, bool isOfSeveral = false)
    {
        JsonOptions options = new(names, settings);
        if (isOfSeveral)
        {
            options.Put(RigOptions.Rig, "of the request");
        }

        IReadOnlyDictionary<string, JsonElement> replaced = changes ?? new Dictionary<string, JsonElement>();
        foreach ((string key, JsonElement value) in given.Where(pair => !IsReplaced(pair.Key, replaced)).Concat(replaced))
        {
            options.Add(key, value);
        }

        options.AddLook();
        return options.Finish(needsPlace);
    }

    private void AddLook()
    {
        OptionValues values = LookOptions.Behind(new OptionValues(_values));
        _values.Remove(LookOptions.Look.Name);
        foreach (OptionSpec option in LookOptions.Options.Where(option => option != NativeOptions.Exposure)) // found for whole runs only
        {
            if (values.Words(option) is { } words)
            {
                _values.TryAdd(option.Name, new OptionValue(words));
            }
        }
    }

    /// <summary>Whether changes leave an option out: those that say where the camera is replace all of them.</summary>
    private static bool IsReplaced(string key, IReadOnlyDictionary<string, JsonElement> changes) =>
        changes.ContainsKey(key)
        || (IsPlace(key) && changes.Keys.Any(other => Ways.Contains(other)));

    /// <summary>Whether an option says where the camera is, or belongs to one that does.</summary>
    public static bool IsPlace(string key) =>
        key == RequestStates.Key || CameraOptions.Group.Options.Any(option => option.Key == key);

    private RequestedFrame Finish(bool needsPlace)
    {
        OptionValues values = new(_values);
        int pixelsPerDegree = SurfaceOptions.Resolution.Read(values);
        bool hasResolution = values.IsGiven(SurfaceOptions.Resolution);
        if (_model is { IsSeveral: false } named && hasResolution && named.Resolution.PixelsPerDegree != pixelsPerDegree)
        {
            throw new UsageException(
                $"'{ModelKey}' {named.Name} has {named.Resolution}, but {SurfaceOptions.Resolution.Name} is {pixelsPerDegree}. "
                    + "Leave one out.").About(SurfaceOptions.Resolution);
        }

        if (_model is { IsSeveral: true } && hasResolution)
        {
            throw SurfaceOptions.Resolution.Wrong("has no meaning with several models: each has its own resolution. Leave it out.");
        }

        ServedModel model = _model
            ?? (hasResolution ? _names.Model(pixelsPerDegree) : _names.Models.All.First(served => served.IsWholeMoon));
        if (model.Ldem.Count > 0)
        {
            _values[SurfaceOptions.Ldem.Name] = new OptionValue(model.Ldem);
        }

        if (!model.IsSeveral)
        {
            Put(SurfaceOptions.Resolution, model.Resolution.NumberText);
        }

        TrajectorySettings? place = ReadPlace(needsPlace);
        values = new OptionValues(_values);
        RenderSettings settings = RenderSettingsReader.Read(values, name => _camera ?? _names.Camera(name), known: model.Resolution) with
        {
            Jitter = _jitter,
        };
        if (settings.Native.FindsExposure)
        {
            throw NativeOptions.Exposure.Wrong(
                $"{NativeOptions.Automatic} is found from the images of a whole run, and a request is one image. Give a number.");
        }

        if (settings.Native.FindsExposureTime)
        {
            throw NativeOptions.ExposureTime.Wrong(
                $"{NativeOptions.Automatic} is found from the images of a whole run, and a request is one image. Give seconds.");
        }

        return new RequestedFrame(
            settings.Native.Refine is { } detail ? _names.Models.Refined(model, detail) : model, place, settings)
        {
            Noise = TrajectorySettingsReader.ReadNoise(values),
        };
    }

    private TrajectorySettings? ReadPlace(bool isNeeded)
    {
        if (_states is { } states)
        {
            return OnTrajectory(ReadStates(states));
        }

        OptionValues values = new(_values);
        TrajectorySettings? place = isNeeded
            ? TrajectorySettingsReader.Read(values)
            : TrajectorySettingsReader.ReadIfGiven(values, CameraOptions.BatchFile);
        return place is SampledSettings sampled ? sampled with { Samples = sampled.Samples with { Content = _samples } } : place;
    }

    private SampledPosition ReadStates(JsonElement states)
    {
        if (states.ValueKind != JsonValueKind.Array)
        {
            return _names.Trajectory(JsonText.Of(states, $"'{RequestStates.Key}'"));
        }

        OrbitFrame frame = CameraOptions.OrbitFrame.Read(new OptionValues(_values));
        _values.Remove(CameraOptions.OrbitFrame.Name);
        return RequestStates.Read(states, frame);
    }

    /// <summary>The options beside a trajectory are those beside an OEM.</summary>
    private MissionSettings OnTrajectory(SampledPosition trajectory)
    {
        Put(MissionOptions.Oem, RequestStates.Key);
        try
        {
            return (MissionSettings)TrajectorySettingsReader.Read(new OptionValues(_values)) with { Position = trajectory };
        }
        catch (UsageException wrong)
        {
            throw new UsageException(
                wrong.Message.Replace(MissionOptions.Oem.Name, $"'{RequestStates.Key}'", StringComparison.Ordinal), wrong)
            {
                Options = wrong.Options,
            };
        }
    }

    private void Add(string key, JsonElement value)
    {
        if (key == ModelKey)
        {
            _model = _names.Models.Named(value.ValueKind == JsonValueKind.Array
                ? [.. value.EnumerateArray().Select(name => JsonText.Of(name, $"'{ModelKey}'"))]
                : [JsonText.Of(value, $"'{ModelKey}'")]);
        }
        else if (key == RequestStates.Key)
        {
            _states = value;
        }
        else if (key == ScanOptions.Jitter.Key)
        {
            string lines = RequestRows.Text(value, key, "a list of [seconds, roll, pitch, yaw], or of [axis, Hz, microradians, rad]");
            _jitter = ScanOptions.Jitter.NamedInErrors(() => JitterFile.Of(key, Encoding.UTF8.GetBytes(lines)));
        }
        else if (key == ScanOptions.Trajectory.Key)
        {
            _samples = RequestRows.Text(value, key, "a list of states, [MJD, rx, ry, rz, qx, qy, qz, q0] each");
            Put(ScanOptions.Trajectory, key);
        }
        else if (key == ImageOptions.Camera.Key && value.ValueKind == JsonValueKind.Object)
        {
            _camera = ImageOptions.Camera.NamedInErrors(() => CameraFileReader.Parse(
                Encoding.UTF8.GetBytes(value.GetRawText()), InlineCamera, mayNameFiles: false));
            Put(ImageOptions.Camera, InlineCamera);
        }
        else
        {
            Add(OptionOf(key), value);
        }
    }

    private void Add(OptionSpec option, JsonElement value)
    {
        string? text = option switch
        {
            FlagSpec => value.ValueKind switch
            {
                JsonValueKind.True => string.Empty,
                JsonValueKind.False => null,
                _ => throw option.Wrong($"is {JsonText.Shown(value)}; true or false is needed."),
            },
            TextSpec { ValueIfBare: { } bare } when value.ValueKind == JsonValueKind.True => bare,
            TextSpec { ValueIfBare: not null } when value.ValueKind == JsonValueKind.False => null,
            NumberListSpec when value.ValueKind == JsonValueKind.Array => $"{{{JsonText.Joined(value, ",", option.Name)}}}",
            _ when value.ValueKind == JsonValueKind.Array => JsonText.Joined(value, option.ListSeparator ?? ",", option.Name),
            _ => JsonText.Of(value, option.Name),
        };
        if (option == AlbedoOptions.Map)
        {
            _values[option.Name] = new OptionValue(
                [.. text!.Split(PathSpec.Separator).Select(map => _names.AlbedoMap(option.Key, AlbedoMapPath.Parse(map)))]);
            return;
        }

        Put(
            option,
            option == NativeOptions.HapkeMap ? _names.Map(option.Key, text!)
                : NavigationOptions.Lists.Contains(option) || (option == SkyOptions.Stars && text is not null && SkyOptions.IsFile(text))
                    ? _names.Catalogue(option.Key, text!)
                : text);
        if (option == RendererOptions.Renderer && RendererOptions.Renderer.Read(new OptionValues(_values)) != RendererKind.Native)
        {
            throw option.Wrong($"{text}: the server draws with the native renderer only. Leave it out.");
        }
    }

    private void Put(OptionSpec option, string? text)
    {
        if (text is not null)
        {
            _values[option.Name] = new OptionValue(text.Length == 0 && option is FlagSpec ? [] : [text]);
        }
    }

    private static OptionSpec OptionOf(string key)
    {
        if (Allowed.TryGetValue(key, out OptionSpec? option))
        {
            return option;
        }

        if (CommandTable.OptionsOfRun.Any(other => other.Key == key))
        {
            throw new UsageException(
                $"'{key}' can't be in a request: it names a file, or belongs to a run of many images. Leave it out.");
        }

        string[] keys = [.. Allowed.Keys, ModelKey, RequestStates.Key, ScanOptions.Jitter.Key, ScanOptions.Trajectory.Key];
        throw new UsageException($"{NumberText.Shown(key)} is not an option{NearestName.Question(key, keys, ".")}");
    }
}
