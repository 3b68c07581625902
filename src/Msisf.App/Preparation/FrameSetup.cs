using Msisf.Adapters.Scene;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Ephemeris;
using Msisf.Core.Navigation;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Scene;
using Msisf.Core.Sky;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>Converts the states of a run to frames with cameras and lights.</summary>
internal static class FrameSetup
{
    /// <summary>The frames to make. The Sun's positions are computed one after another, because CSPICE is not thread-safe.</summary>
    /// <param name="states">The states of the whole run, in the order of the input.</param>
    /// <param name="settings">The settings of the run, which also select the steps to make.</param>
    /// <param name="sun">Where the Sun is; not used if it is ignored.</param>
    /// <param name="sky">How the sky lies; null where none is drawn.</param>
    /// <exception cref="MsisfException">A step is not part of the run, a time lies outside the kernels' coverage, ...</exception>
    public static Frame[] Of(
        IReadOnlyList<SpacecraftState> states, IReadOnlyList<string> names, RenderSettings settings, SunPositions sun,
        CancellationToken cancellation, SkyPositions? sky = null)
    {
        CameraModel model = settings.CameraModel;
        List<Frame> frames = [];
        foreach (int step in settings.StepsOf(states.Count))
        {
            cancellation.ThrowIfCancellationRequested();
            SpacecraftState state = states[step - 1];
            RefuseUndrawable(step, state, settings.Renderer);
            ICamera camera = CameraOf(state);
            if (settings.Rig is not null && state.Sky?.OfGround == Aberration.LightTimeAndStellar)
            {
                throw new UsageException(
                    $"the sky: with {MissionOptions.OfGround.Name} lt+s the ground of a rig's cameras is turned by what its body sees, so "
                        + "that stars would not fit it. Take lt or none, or leave one of them out.")
                    .About(MissionOptions.OfGround);
            }

            frames.Add(new Frame(
                step, names[step - 1], state.Time, camera, LightOf(FlowState.Of(state)), state.Motion, state.Noise)
            {
                CameraIndex = settings.Rig?.Index ?? 0,
                ExposureFactor = state.ExposureFactor,
                Path = state.Path,
                Scan = settings.Scan,
                Model = model,
                Sky = sky?.Of(camera, state.Time, state.Sky) ?? [],
                Earth = sky?.EarthLightOf(camera, state.Time),
                Flow = state.Flow is { } flow
                    ? new FlowTarget(
                        model.At(new CameraState(flow.PositionBodyFixed, flow.MoonFromCamera)), LightOf(flow))
                    : null,
            });
        }

        return [.. frames];

        ICamera CameraOf(SpacecraftState state) => settings.Scan is { } scan
            ? scan.CameraOf(model, [.. PathOf(state).States.Select(exposure => exposure with
            {
                SunPositionBodyFixed = settings.IgnoreSun ? null
                    : state.SunPositionBodyFixed ?? sun.At(state.Time.After(exposure.Seconds)),
            })])
            : model.At(new CameraState(state.PositionBodyFixed, state.MoonFromCamera));

        SceneLight LightOf(FlowState at) => settings.IgnoreSun
            ? new SceneLight(at.PositionBodyFixed, IsSun: false)
            : new SceneLight(at.SunPositionBodyFixed ?? sun.At(at.Time), IsSun: true);
    }

    private static ScanPath PathOf(SpacecraftState state) => state.Path ?? throw new UsageException(
        "these states are single ones, and the rows of a camera that scans need to know how it moves. Remove 'scan' from the camera file.")
        .About(ImageOptions.Camera);

    private static void RefuseUndrawable(int step, SpacecraftState state, RendererKind renderer)
    {
        double distance = state.PositionBodyFixed.Length;
        if (distance == 0.0)
        {
            throw new BadInputException($"the camera of step {step} is at the Moon's centre. Choose a position above the terrain.");
        }

        if (renderer == RendererKind.PovRay && distance > PovSceneWriter.MaxDistance)
        {
            throw new BadInputException(Invariant(
                $"the camera of step {step} is {distance:E3} m from the Moon's centre; "
                    + $"POV-Ray draws nothing beyond {PovSceneWriter.MaxDistance:E0} m. "
                    + $"Use --renderer native, or move it closer on the same line, with a field of view that is larger by as much."));
        }
    }
}

/// <summary>One image to render.</summary>
/// <param name="Step">Number of the frame, from 1, in the order of the input.</param>
/// <param name="Name">File name of its outputs, without extension.</param>
/// <param name="Time">Time, UTC.</param>
/// <param name="Light">The Sun, or the lamp at the camera.</param>
/// <param name="Motion">How the camera moves during the exposure; null for images without it.</param>
/// <param name="Noise">The noise of the camera's detector; null for that of the detector's seed and the frame's state.</param>
internal sealed record Frame(
    int Step, string Name, Instant Time, ICamera Camera, SceneLight Light, CameraMotion? Motion = null,
    NoiseSeed? Noise = null)
{
    /// <summary>Which camera of the rig takes it, from 0; 0 without a rig.</summary>
    public int CameraIndex { get; init; }

    /// <summary>By how much longer it is exposed; null for as long as the settings say.</summary>
    public double? ExposureFactor { get; init; }

    /// <summary>The frame to which its flow leads; null without a flow.</summary>
    public FlowTarget? Flow { get; init; }

    /// <summary>How the camera moves in all the time of the image; null where it does not scan and has no jitter.</summary>
    public ScanPath? Path { get; init; }

    /// <summary>How the image is scanned; null for a frame.</summary>
    public Scan? Scan { get; init; }

    public CameraModel? Model { get; init; }

    /// <summary>How the sky lies, for each band of the camera; empty where none is drawn.</summary>
    public IReadOnlyList<SkyAxes> Sky { get; init; } = [];

    /// <summary>The Earth as a second light; null without earthshine.</summary>
    public SecondLight? Earth { get; init; }

    /// <summary>
    /// The image as it is exposed part by part: a scan, or the rows of a frame with a rolling shutter whose camera moves; null for others.
    /// </summary>
    /// <param name="detector">As it exposes this image.</param>
    public ScannedShot? ShotOf(DetectorSettings detector)
    {
        double halfExposure = detector.Shutter is null ? 0.0 : 0.5 * detector.ExposureTime;
        if (Scan is not null)
        {
            return new ScannedShot(Scan, Model!, Path!, Camera, Light, Time, Noise, halfExposure);
        }

        if (detector.Shutter is not { IsRolling: true, LineTime: var period } || Motion is not { IsRest: false } motion)
        {
            return null;
        }

        Scan rows = new(ScanKind.RollingShutter, Camera.Height, period);
        double first = -0.5 * rows.SecondsOf(rows.Count - 1); // the frame's time is the middle of its middle row
        CameraState state = Camera.State;
        ScanPath path = new ScanPath(seconds => Path?.At(first + seconds) ?? motion.Moved(state, first + seconds)).Of(rows, null, 0.0);
        return new ScannedShot(rows, Model!, path, rows.CameraOf(Model!, path.States), Light, Time, Noise, halfExposure);
    }

    /// <summary>The camera for POV-Ray.</summary>
    /// <exception cref="BadInputException">Its rows have several states.</exception>
    public FrameCamera FrameCamera => Camera as FrameCamera ?? throw new BadInputException(
        "the rows of this camera have times and places of their own, which POV-Ray can't draw. Use --renderer native.");
}
