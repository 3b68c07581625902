using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Detector;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>
/// The states of a run and the frames of one of its cameras. The elevation model is opened only if a camera is placed or pointed by it.
/// </summary>
/// <param name="States">The states of all frames of the camera, in the order of the input.</param>
/// <param name="Names">File names of all frames, without extension.</param>
/// <param name="Frames">The frames to make.</param>
internal sealed record RunFrames(
    RenderSettings Settings, IReadOnlyList<SpacecraftState> States, IReadOnlyList<string> Names, IReadOnlyList<Frame> Frames)
{
    /// <summary>
    /// The states from which pieces of the run make the same frames: of the body that carries the cameras of a rig, without jitter, and
    /// with the motion of a camera that scans.
    /// </summary>
    public required IReadOnlyList<SpacecraftState> BodyStates { get; init; }

    /// <summary>Reads the states and sets up the frames.</summary>
    /// <param name="trajectory">The positions of the camera, or of the body that carries several.</param>
    /// <param name="cameras">The run's other settings: those of each camera.</param>
    /// <param name="ephemeris">Opened if the states or the Sun need it.</param>
    /// <param name="model">Opened if a camera is placed or pointed by the terrain.</param>
    /// <returns>Those of each camera.</returns>
    public static IReadOnlyList<RunFrames> Read(
        TrajectorySettings trajectory,
        IReadOnlyList<RenderSettings> cameras,
        EphemerisSource ephemeris,
        ModelOnDemand model,
        ProgramHost host,
        CancellationToken cancellation)
    {
        RefuseUnrepeatable(trajectory, cameras);
        foreach (RenderSettings settings in cameras)
        {
            ExposureRoom.Check(settings, GC.GetGCMemoryInfo().TotalAvailableMemoryBytes);
        }

        RenderSettings first = cameras[0];
        RunGeometry geometry = new(() => model.Opened, ephemeris.Engine, ephemeris.TimeScale, first.Aberration, first.Body);
        StateNeeds[] needs = [.. cameras.Select(StateNeeds.Of)];
        StateReader reader = new(ephemeris.Engine, geometry, host)
        {
            Body = first.Body,
            Kernels = ephemeris.Kernels,
            Needs = needs,
        };
        IReadOnlyList<SpacecraftState> read = host.Times.Measure(Phase.States, () => reader.ReadBody(trajectory, cancellation));
        SunPositions sun = new(ephemeris.Engine, first.Aberration, cameras.Count > 1 ? new SharedReadings() : null);
        return [.. cameras.Select((settings, index) =>
        {
            SkyPositions? sky = settings.Native.Sky is { } wanted
                ? new SkyPositions(ephemeris.Engine, wanted, geometry.ReferenceRadius)
                : null;
            IReadOnlyList<SpacecraftState> states = host.Times.Measure(
                Phase.States, () => FlowStates.Of(needs[index].Of(read, trajectory), settings));
            IReadOnlyList<string> names = new FrameNaming(settings.OutputName, settings.Rig?.Name)
                .NamesOf([.. states.Select(state => state.Time)]);
            Frame[] frames = host.Times.Measure(Phase.Sun, () => FrameSetup.Of(states, names, settings, sun, cancellation, sky));
            return new RunFrames(settings, states, names, frames)
            {
                BodyStates = needs.Any(needed => needed.NeedsPath) ? MovingOf(read, trajectory, needs)
                    : settings.Rig is null ? states
                    : ((needs.FirstOrDefault(needed => needed.CameraWithShutter is not null) ?? needs[index]) with { Mounting = null })
                        .Of(read, trajectory),
            };
        })];
    }

    /// <summary>The states as they were read, with the motion and noise that are said beside them.</summary>
    private static IReadOnlyList<SpacecraftState> MovingOf(
        IReadOnlyList<SpacecraftState> read, TrajectorySettings trajectory, StateNeeds[] needs) => StateNoise.Of(
        [.. read.Select(state => state with { Motion = trajectory.Motion ?? state.Motion })], trajectory,
        needs.Any(needed => needed.HasDetector));

    /// <summary>An exposure time is found from the whole run again by each piece and restart.</summary>
    private static void RefuseUnrepeatable(TrajectorySettings trajectory, IReadOnlyList<RenderSettings> cameras)
    {
        if (cameras.Any(settings => settings.Native.FindsExposureTime) && trajectory is BatchFileSettings { IsStandardInput: true })
        {
            throw NativeOptions.ExposureTime.Wrong(
                $"{NativeOptions.Automatic} reads the whole run again in each call, and standard input can be read once. Give seconds, "
                    + "or save the states to a file.", CameraOptions.BatchFile);
        }
    }

    /// <summary>Warns of a --fov that is most likely meant in another unit, and notes an unusual band.</summary>
    /// <param name="referenceRadius">m: radius of the sphere over which heights are counted.</param>
    public void WarnOfCamera(ProgramHost host, double referenceRadius)
    {
        DetectorSettings? detector = Settings.Native.Detector?.Settings;
        foreach (string note in PlausibleMistakes.Band(detector?.Response).Concat(PlausibleMistakes.Wings(detector?.FarWings)))
        {
            host.Log.Note(note);
        }

        foreach (Frame frame in Frames)
        {
            ScanCheck.Check(frame, host.Log, referenceRadius);
        }

        if (Settings.Camera is not null)
        {
            return;
        }

        double cell = Settings.Resolution.OnSphere(referenceRadius).MetresPerPixel;
        double widest = Frames.Max(frame => PlausibleMistakes.WidthOnGround(frame, referenceRadius));
        foreach (string mistake in PlausibleMistakes.FieldOfView(Settings.FieldOfViewDegrees, widest, cell))
        {
            host.Log.Warning(mistake);
        }
    }
}

/// <summary>Rejects scans whose states do not fit into memory.</summary>
internal static class ExposureRoom
{
    /// <summary>Bytes of a scan's exposure: its state, its camera, and what is written of it.</summary>
    private const long BytesOfExposure = 2200;

    /// <summary>Checks the memory for the states of a scan's exposures, before they are made.</summary>
    /// <param name="memoryThere">Bytes of memory that can be used.</param>
    /// <exception cref="BadInputException">It is not sufficient.</exception>
    public static void Check(RenderSettings settings, long memoryThere)
    {
        long needed = BytesOfExposure * (settings.Scan?.Count ?? 0);
        if (needed > memoryThere)
        {
            throw new BadInputException(Invariant(
                $"the states of {settings.Scan!.Count} exposures of a scan need {needed >> 20} MiB of memory, {memoryThere >> 20} MiB are "
                    + $"there. Make the scan in parts of fewer exposures, each from its own --time on."));
        }
    }
}
