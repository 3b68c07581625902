using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Render.Options;
using Msisf.Core.Scene;

namespace Msisf.App.Serving;

/// <summary>A frame that a client asks for; its options are checked.</summary>
/// <param name="Model">The elevation model.</param>
/// <param name="Place">Where the camera is; null if the request need not say it and does not.</param>
/// <param name="Settings">The other options.</param>
internal sealed record RequestedFrame(ServedModel Model, TrajectorySettings? Place, RenderSettings Settings)
{
    private readonly Lazy<string> _sessionKey = new(() => $"{Model.Name} {KeyOf(Settings)}");

    /// <summary>The noise of the frame's detector, of a stream that of its first frame; null if the client does not choose it.</summary>
    public NoiseSeed? Noise { get; init; }

    /// <summary>Tells sessions apart: all options but those that say where the camera is.</summary>
    public string SessionKey => _sessionKey.Value;

    /// <summary>Key that distinguishes the maps of sessions.</summary>
    public string MapsKey => MapsKeyOf(Settings);

    /// <summary>The same frame as a camera of a rig has it.</summary>
    /// <param name="rig">The camera; null for one that is where the state is.</param>
    public RequestedFrame On(RigCamera? rig) => rig is null
        ? this
        : new RequestedFrame(Model, Place, Settings with { Rig = rig }) { Noise = Noise }; // with a session key of its own

    /// <summary>The frame at the place of another one; motion, Sun, exposure and noise stay its own.</summary>
    public RequestedFrame At(TrajectorySettings? place) => place is null || Place is null ? this : this with
    {
        Place = place with
        {
            Motion = Place.Motion,
            SunPositionBodyFixed = Place.SunPositionBodyFixed,
            ExposureFactor = Place.ExposureFactor,
            Noise = Place.Noise,
        },
    };

    /// <summary>Whether single rays tell what the image shows: the Sun is a point, and the normals are those of facets.</summary>
    public bool IsTraceable => Settings.Native.Render is { Sun: SunModel.Point, Normals: NormalModel.Facet };

    private static string KeyOf(RenderSettings settings)
    {
        bool hasTruth = settings.Native.Render.KeepGroundTruth;
        bool hasDetector = settings.Native.Detector is not null;
        return $"{FrameArguments.OfSettings(settings, settings.Ephemeris)} {MapsKeyOf(settings)} {settings.Camera?.Sha256} {hasTruth} "
            + $"{hasDetector} {ListsKeyOf(settings)} {RigKeyOf(settings.Rig)}";
    }

    private static string MapsKeyOf(RenderSettings settings) =>
        $"{settings.Albedo.Key} {settings.Native.ReflectanceText} {settings.Native.HapkeMap}";

    private static string RigKeyOf(RigCamera? rig) => rig is null ? string.Empty : string.Join(' ', rig.Cameras
        .Select(camera => FormattableString.Invariant(
            $"{camera.Name} {camera.Mounting.BodyFromCamera} {camera.Mounting.OffsetBody}"))
        .Prepend(rig.Name));

    private static string ListsKeyOf(RenderSettings settings) =>
        $"{settings.Native.Navigation?.Craters} {settings.Native.Navigation?.Landmarks} {settings.Native.Navigation?.Columns} "
            + $"{settings.Native.Sky?.Catalogue}";
}
