using System.Text.Json;
using Msisf.App.Serving;
using Msisf.App.Settings;
using Msisf.Core.Camera;

namespace Msisf.Server;

/// <summary>A camera of a stream.</summary>
/// <param name="Options">The options in which its images differ from those of the other cameras.</param>
/// <param name="Rig">How it and the others sit on the body whose states come; null for cameras that are all where the state is.</param>
internal sealed record StreamCamera(IReadOnlyDictionary<string, JsonElement> Options, RigCamera? Rig)
{
    public const string ListKey = "cameras";

    /// <summary>Key of the options of all cameras.</summary>
    public const string FrameKey = "frame";

    /// <summary>More than a spacecraft carries.</summary>
    private const int Most = 16;

    public const string NameKey = "name";

    private const string QuaternionKey = "quaternion";
    private const string OffsetKey = "offset";

    /// <summary>Reads the cameras; a rig if one of them has a name or a mounting.</summary>
    /// <param name="cameras">A list of objects.</param>
    /// <param name="frame">The options of all cameras.</param>
    public static IReadOnlyList<StreamCamera> Read(JsonElement cameras, JsonElement frame)
    {
        if (cameras.ValueKind != JsonValueKind.Array || cameras.GetArrayLength() is < 1 or > Most)
        {
            throw new UsageException(
                $"'{ListKey}' is {JsonText.Shown(cameras)}; a list of 1 to {Most} objects with the options of each camera is needed.");
        }

        IReadOnlyDictionary<string, JsonElement>[] members = [.. cameras.EnumerateArray().Select(JsonText.Members)];
        if (!members.Any(camera => Keys.Any(camera.ContainsKey)))
        {
            return [.. members.Select(camera => new StreamCamera(camera, Rig: null))];
        }

        bool isRounded = frame.ValueKind == JsonValueKind.Object
            && frame.TryGetProperty(CameraOptions.Normalize.Key, out JsonElement normalize) && normalize.ValueKind == JsonValueKind.True;
        MountedCamera[] mounted = [.. members.Select((camera, index) => MountedOf(camera, index, isRounded))];
        return mounted.Select(camera => camera.Name).Distinct(StringComparer.OrdinalIgnoreCase).Count() == mounted.Length
            ? [.. members.Select((camera, index) => new StreamCamera(
                camera.Where(option => !Keys.Contains(option.Key)).ToDictionary(), new RigCamera(mounted, index)))]
            : throw new UsageException("two of the 'cameras' have one name. Give each its own, or none.");
    }

    /// <summary>Keys that are not options of an image.</summary>
    public static IReadOnlyList<string> Keys { get; } = [NameKey, QuaternionKey, OffsetKey];

    /// <summary>The camera's name: camera1, camera2, ... if it has none.</summary>
    public string NameAt(int index) => Rig?.Name ?? DefaultName(index);

    /// <summary>The camera's frame where the options of all cameras say where the body is.</summary>
    /// <param name="frame">The options of all cameras.</param>
    public RequestedFrame Of(FrameService frames, JsonElement frame) => frames.Read(frame, Options, isOfSeveral: true).On(Rig);

    /// <summary>The camera's frame in a stream.</summary>
    /// <param name="frame">The options of all cameras.</param>
    /// <param name="changes">What a later message says in their place, with where the camera is; null for the first one.</param>
    public RequestedFrame InStream(FrameService frames, JsonElement frame, IReadOnlyDictionary<string, JsonElement>? changes = null) =>
        frames.Read(
            frame,
            changes is null ? Options : Options.Where(option => !changes.ContainsKey(option.Key)).Concat(changes).ToDictionary(),
            needsPlace: changes is not null).On(Rig);

    /// <summary>The frames of cameras with the place of the first one, whose states are then read once.</summary>
    /// <param name="frames">Their frames; as they are if a camera says itself where it is.</param>
    public static IReadOnlyList<RequestedFrame> WithOnePlace(IReadOnlyList<StreamCamera> cameras, IReadOnlyList<RequestedFrame> frames) =>
        cameras.Any(camera => camera.Options.Keys.Any(JsonOptions.IsPlace))
            ? frames
            : [.. frames.Select(frame => frame.At(frames[0].Place))];

    private static MountedCamera MountedOf(IReadOnlyDictionary<string, JsonElement> camera, int index, bool isRounded)
    {
        string name = camera.TryGetValue(NameKey, out JsonElement given) ? JsonText.Of(given, "'name'") : DefaultName(index);
        if (!MountedCamera.IsName(name))
        {
            throw new UsageException($"'{name}' is not a name of a camera: {MountedCamera.Names}.");
        }

        try
        {
            return new MountedCamera(
                name,
                Mounting.Of(Numbers(camera, QuaternionKey, [0.0, 0.0, 0.0, 1.0]), Numbers(camera, OffsetKey, [0.0, 0.0, 0.0]), isRounded));
        }
        catch (BadInputException wrong)
        {
            throw new UsageException($"camera '{name}': {wrong.Message}", wrong);
        }
    }

    private static string DefaultName(int index) => $"camera{index + 1}";

    private static double[] Numbers(IReadOnlyDictionary<string, JsonElement> camera, string key, double[] otherwise)
    {
        if (!camera.TryGetValue(key, out JsonElement list))
        {
            return otherwise;
        }

        double[] numbers = list.ValueKind == JsonValueKind.Array
            ? [.. list.EnumerateArray().Select(value => value.ValueKind == JsonValueKind.Number ? value.GetDouble() : double.NaN)]
            : [];
        return numbers.Length == otherwise.Length && numbers.All(double.IsFinite)
            ? numbers
            : throw new UsageException($"'{key}' of a camera is {JsonText.Shown(list)}; a list of {otherwise.Length} numbers is needed.");
    }
}
