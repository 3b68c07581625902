using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Errors;
using Msisf.Core.Render;
using Msisf.Core.Scene;

namespace Msisf.App.Cluster;

/// <summary>Checks a run as the render command does, down to the cameras: what a piece would refuse is refused before there is a script.</summary>
internal static class RunPlanner
{
    /// <summary>Checks all of a run.</summary>
    /// <param name="camera">Where the camera is.</param>
    /// <param name="settings">The run's other options.</param>
    /// <param name="host">The world.</param>
    /// <param name="cancellation">Ends it.</param>
    /// <exception cref="MsisfException">The run could not be made.</exception>
    public static PlannedRun Plan(CameraSettings camera, RenderSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        if (camera is BatchFileSettings { IsStandardInput: true })
        {
            throw new UsageException("--batch-file -: standard input can't be read again by each piece. Save it to a file, and give that.");
        }

        using EphemerisSource ephemeris = new(settings, host);
        IReadOnlyList<SpacecraftState> states = new StateSource(ephemeris.Engine, host).Read(camera, cancellation);
        IReadOnlyList<string> names = new FrameNaming(settings.OutputName).NamesOf([.. states.Select(state => state.Time)]);
        Frame[] frames = FramePlanner.Plan(states, names, settings, ephemeris.Engine, cancellation);
        ElevationModel model = ElevationModel.Open(settings.Ldem, settings.PixelsPerDegree, isSparing: settings.Renderer == RendererKind.PovRay, host);
        try
        {
            FramePlanner.RefuseCamerasInTheGround(frames, model, cancellation);
            return new PlannedRun((camera as BatchFileSettings)?.Path, settings, ephemeris.Opened?.Choice, states, frames, model);
        }
        catch (MsisfException)
        {
            model.Dispose();
            throw;
        }
    }
}
