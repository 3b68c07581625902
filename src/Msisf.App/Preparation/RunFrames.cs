using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Errors;
using Msisf.Core.Scene;

namespace Msisf.App.Preparation;

/// <summary>The states of a run and its frames. The elevation model is opened only if a camera is placed or pointed by it.</summary>
/// <param name="States">The states of all frames of the run, in the order of the input.</param>
/// <param name="Names">File names of all frames, without extension.</param>
/// <param name="Frames">The frames to make.</param>
internal sealed record RunFrames(IReadOnlyList<SpacecraftState> States, IReadOnlyList<string> Names, IReadOnlyList<Frame> Frames)
{
    /// <summary>Reads the states and sets up the frames.</summary>
    /// <param name="trajectory">The positions of the camera.</param>
    /// <param name="settings">The run's other settings.</param>
    /// <param name="ephemeris">Opened if the states or the Sun need it.</param>
    /// <param name="model">Opened if a camera is placed or pointed by the terrain.</param>
    /// <param name="host">Output, log, clock and environment of the program.</param>
    /// <param name="cancellation">Cancels the work.</param>
    /// <exception cref="MsisfException">The run can't be made.</exception>
    public static RunFrames Read(
        TrajectorySettings trajectory,
        RenderSettings settings,
        EphemerisSource ephemeris,
        ModelOnDemand model,
        ProgramHost host,
        CancellationToken cancellation)
    {
        RefuseUnrepeatable(trajectory, settings);
        RunGeometry geometry = new(() => model.Opened, ephemeris.Engine, settings.Aberration, settings.Body);
        StateReader reader = new(ephemeris.Engine, geometry, host)
        {
            Body = settings.Body,
            Kernels = ephemeris.Kernels,
            CameraWithShutter = settings.Shutter is null ? null : settings.Camera!.Name,
            Scan = settings.Scan,
            Jitter = settings.Jitter,
            ExposureReach = settings.ExposureReach,
            HasDetector = settings.Native.Detector is not null,
        };
        IReadOnlyList<SpacecraftState> states = host.Times.Measure(
            Phase.States, () => FlowStates.Of(reader.Read(trajectory, cancellation), settings));
        IReadOnlyList<string> names = new FrameNaming(settings.OutputName).NamesOf([.. states.Select(state => state.Time)]);
        Frame[] frames = host.Times.Measure(Phase.Sun, () => FrameSetup.Of(states, names, settings, ephemeris.Engine, cancellation));
        return new RunFrames(states, names, frames);
    }

    /// <summary>An exposure time is found from the whole run again by each piece and restart.</summary>
    private static void RefuseUnrepeatable(TrajectorySettings trajectory, RenderSettings settings)
    {
        if (settings.Native.FindsExposureTime && trajectory is BatchFileSettings { IsStandardInput: true })
        {
            throw new UsageException(
                $"{NativeOptions.ExposureTime.Name} {NativeOptions.AutomaticTime} reads the whole run again in each call, and standard "
                    + "input can be read once. Give seconds, or save the states to a file.")
                .About(NativeOptions.ExposureTime, CameraOptions.BatchFile);
        }
    }

    /// <summary>Warns of a --fov that is most likely meant in another unit, and notes an unusual band.</summary>
    /// <param name="settings">The run's settings.</param>
    /// <param name="host">Output, log, clock and environment of the program.</param>
    /// <param name="referenceRadius">m: radius of the sphere over which heights are counted.</param>
    public void WarnOfCamera(RenderSettings settings, ProgramHost host, double referenceRadius)
    {
        foreach (string note in PlausibleMistakes.Band(settings.Native.Detector?.Settings.Response))
        {
            host.Log.Note(note);
        }

        foreach (Frame frame in Frames)
        {
            ScanCheck.Check(frame, host.Log, referenceRadius);
        }

        if (settings.Camera is not null)
        {
            return;
        }

        double cell = settings.Resolution.OnSphere(referenceRadius).MetresPerPixel;
        double widest = Frames.Max(frame => PlausibleMistakes.WidthOnGround(frame, referenceRadius));
        foreach (string mistake in PlausibleMistakes.FieldOfView(settings.FieldOfViewDegrees, widest, cell))
        {
            host.Log.Warning(mistake);
        }
    }
}
