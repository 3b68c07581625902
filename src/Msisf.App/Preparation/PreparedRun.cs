using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.Core.Errors;
using Msisf.Core.Scene;

namespace Msisf.App.Preparation;

/// <summary>
/// A run whose input and cameras were read and checked; a run that could not be finished is rejected before the first image.
/// </summary>
/// <param name="States">The states of all frames of the run, in the order of the input.</param>
/// <param name="Names">File names of all frames, without extension.</param>
/// <param name="Frames">The frames to make.</param>
/// <param name="Model">The elevation model; disposed with this object.</param>
internal sealed record PreparedRun(
    IReadOnlyList<SpacecraftState> States, IReadOnlyList<string> Names, IReadOnlyList<Frame> Frames, ElevationModel Model) : IDisposable
{
    /// <summary>Which kernels give the body's frame, for cameras on the trajectory of a mission; null for others.</summary>
    public string? Orientation { get; private init; }

    /// <summary>Reads the states, sets up the frames, opens the elevation model, and checks all of it.</summary>
    /// <param name="trajectory">The positions of the camera.</param>
    /// <param name="settings">The run's other settings.</param>
    /// <param name="ephemeris">Opened if the states or the Sun need it.</param>
    /// <param name="host">Output, log, clock and environment of the program.</param>
    /// <param name="cancellation">Cancels the work.</param>
    /// <exception cref="MsisfException">The run can't be made.</exception>
    public static PreparedRun Of(
        TrajectorySettings trajectory, RenderSettings settings, EphemerisSource ephemeris, ProgramHost host, CancellationToken cancellation)
    {
        ModelOnDemand model = new(settings, host);
        try
        {
            RunFrames run = RunFrames.Read(trajectory, settings, ephemeris, model, host, cancellation);
            GroundCheck.Refuse(run.Frames, model.Opened, settings.ShutterSpan, cancellation, settings.Body, trajectory);
            run.WarnOfCamera(settings, host, model.Opened.Grid.ReferenceRadius);
            return new PreparedRun(run.States, run.Names, run.Frames, model.Opened)
            {
                Orientation = settings.IsMission ? ephemeris.Orientation : null,
            };
        }
        catch
        {
            model.Dispose();
            throw;
        }
    }

    public void Dispose() => Model.Dispose();
}
