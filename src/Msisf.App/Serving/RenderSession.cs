using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Products;
using Msisf.App.Rendering;
using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.App.Serving;

/// <summary>A camera with its options over an elevation model, ready to draw one frame after another. Thread-safe.</summary>
internal sealed class RenderSession : IDisposable
{
    private readonly ServedModel _model;
    private readonly SharedCache<SurfaceInputs>.Lease _maps;
    private readonly NativeDrawing _drawing;
    private readonly NativeLevels _levels;
    private readonly ServedEphemeris _ephemeris;
    private readonly FrameNavigation? _navigation;
    private readonly FrameDescription _description;
    private readonly IReadOnlyList<InputFile> _lists;
    private readonly ProgramHost _host;

    /// <param name="sky">What the sky is drawn from; null for none.</param>
    public RenderSession(
        RequestedFrame requested, SharedCache<SurfaceInputs>.Lease maps, SkyInputs? sky, ServedEphemeris ephemeris, ProgramHost host)
    {
        Settings = requested.Settings;
        _model = requested.Model;
        _maps = maps;
        _ephemeris = ephemeris;
        _host = host;
        _levels = _model.LevelsFor(Settings.LevelOfDetailError);
        _drawing = new NativeDrawing(
            Settings.Native, _model.Opened.Grid, maps.Value, _levels, host.Times,
            sky is null ? null : new CameraSky(sky, Settings.Albedo.Band));
        NavigationInputs? lists = NavigationInputs.Open(Settings.Native.Navigation, _model.Opened.Grid.ReferenceRadius);
        _navigation = lists is null ? null : new FrameNavigation(lists);
        _lists = [.. lists?.Files ?? [], .. sky?.Files ?? []];
        _description = new FrameDescription(Settings, _model.Opened, host.Version, Inputs);
    }

    public RenderSettings Settings { get; }

    public ElevationModel Model => _model.Opened;

    /// <summary>The canonical arguments of its frames, without their states.</summary>
    public string Arguments => FrameArguments.OfSettings(
        Settings,
        Settings.IgnoreSun ? null : _ephemeris.Of(Settings).Opened?.Choice,
        _maps.Value.WholeAlbedo);

    /// <summary>Reads where the camera is, and sets up the frame.</summary>
    /// <param name="shared">What other cameras of the same request have read; null for none.</param>
    /// <exception cref="MsisfException">There is no such frame.</exception>
    public PreparedFrame Prepare(TrajectorySettings place, CancellationToken cancellation, SharedReadings? shared = null)
    {
        RunGeometry geometry = new(() => Model, () => Engine, () => _ephemeris.Of(Settings).TimeScale(), Settings.Aberration);
        StateNeeds needs = StateNeeds.Of(Settings);
        StateReader reader = new(() => Engine, geometry, _host)
        {
            Needs = [needs],
            Kernels = () => _ephemeris.Of(Settings).Kernels(),
        };
        StatesKey key = new(
            place with { Noise = null }, Model, Settings.Ephemeris, Settings.Aberration, needs.NeedsMotion, needs.NeedsPath);
        IReadOnlyList<SpacecraftState> states = shared?.States(key, Read) ?? Read();
        SpacecraftState state = needs.Of(states, place)[0];
        SkyPositions? sky = Settings.Native.Sky is { } wanted
            ? new SkyPositions(() => Engine, wanted, geometry.ReferenceRadius)
            : null;
        Frame[] frames = FrameSetup.Of(
            [state], ["frame"], Settings, new SunPositions(() => Engine, Settings.Aberration, shared), cancellation, sky);
        GroundCheck.Refuse(frames, Model, Settings.ShutterSpan, cancellation, trajectory: place);
        return new PreparedFrame(state, frames[0]);

        IReadOnlyList<SpacecraftState> Read() => reader.ReadBody(place, cancellation);
    }

    /// <param name="threads">Number of threads; the image does not depend on it.</param>
    public NativeImage Draw(PreparedFrame frame, int threads, CancellationToken cancellation) =>
        _drawing.Draw(frame.Frame, threads, cancellation);

    /// <summary>Follows single rays of a frame on the surface that it shows; the Sun is a point, the normals are those of facets.</summary>
    public FrameTruth TruthOf(PreparedFrame frame) => new(
        frame.Frame,
        _levels.TracerFor(frame.Frame.Camera, Settings.Native.Render.DetailSubsamplesPerAxis),
        _levels.FirstInventedPart(frame.Frame.Camera, Settings.Native.Render.DetailSubsamplesPerAxis));

    /// <summary>Reads pixels of a frame as it is drawn, with smooth normals and penumbras if it has them.</summary>
    /// <param name="pixels">Points of the image; what is read is the middle of the pixel that holds each.</param>
    /// <exception cref="BadInputException">A point lies outside the image.</exception>
    public SurfaceReading?[] ReadDrawn(PreparedFrame frame, IReadOnlyList<double[]> pixels, int threads, CancellationToken cancellation)
    {
        ICamera camera = frame.Frame.Camera;
        NativeRenderer renderer = _levels.For(camera, Settings.Native.Render.DetailSubsamplesPerAxis);
        NativeRenderOptions truth = Settings.Native.Render with
        {
            SubsamplesPerAxis = 1,
            Adaptive = null,
            Indirect = null,
            KeepGroundTruth = true,
        };
        return new DrawnPixels(
            camera,
            window => renderer.Render(window, frame.Frame.Light, truth, threads, cancellation),
            _levels.FirstInventedPart(camera, Settings.Native.Render.DetailSubsamplesPerAxis)).Read(pixels);
    }

    /// <summary>A drawn frame as its products are written from it.</summary>
    public ProductFrame ToProducts(PreparedFrame frame, RenderedFrame rendered, CancellationToken cancellation)
    {
        ProductTools tools = new(
            _host.Log, _host.Environment("MSISF_GDAL"),
            Settings.CameraFormats.Any(format => format.NeedsEphemeris) ? Engine : null);
        FrameMetadata metadata = _description.Describe(frame.Frame, rendered, ArgumentsOf(frame)) with
        {
            Navigation = _navigation?.Of(rendered),
        };
        return _description.ToProducts(frame.Frame, rendered, metadata, tools, cancellation);
    }

    public void Dispose() => _maps.Dispose();

    /// <summary>Takes what the user should know of a frame.</summary>
    public ILog Log => _host.Log;

    /// <summary>Where the Sun is, what time TDB is, and how the body is turned.</summary>
    public IEphemeris Engine => _ephemeris.Of(Settings).Engine();

    private string ArgumentsOf(PreparedFrame frame) => FrameArguments.Of(frame.State, Arguments);

    private IReadOnlyList<InputFile> Inputs() =>
    [
        .. _ephemeris.InputsOf(_model, Settings),
        .. _maps.Value.Files,
        .. _lists,
        .. Settings.Jitter is { } jitter ? [jitter.ToInput()] : (InputFile[])[],
        .. Settings.Camera is { } camera ? [RunInputs.Of(camera)] : (InputFile[])[],
    ];
}

/// <summary>A frame that can be drawn.</summary>
/// <param name="Frame">Its camera and light.</param>
internal sealed record PreparedFrame(SpacecraftState State, Frame Frame);
