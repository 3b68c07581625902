using Msisf.App.Host;
using Msisf.App.Settings;

namespace Msisf.App.Preparation;

/// <summary>
/// A run whose input and cameras were read and checked; a run that could not be finished is rejected before the first image.
/// </summary>
/// <param name="Cameras">The states and frames of each camera; one without a rig.</param>
/// <param name="Model">The elevation model; disposed with this object.</param>
internal sealed record PreparedRun(IReadOnlyList<RunFrames> Cameras, ElevationModel Model) : IDisposable
{
    /// <summary>Which kernels give the body's frame, for cameras on the trajectory of a mission; null for others.</summary>
    public string? Orientation { get; private init; }

    /// <summary>The frames to make, those of a step one after the other.</summary>
    public IReadOnlyList<Frame> Frames { get; } =
        [.. from index in Enumerable.Range(0, Cameras[0].Frames.Count) from camera in Cameras select camera.Frames[index]];

    /// <summary>Reads the states, sets up the frames, opens the elevation model, and checks all of it.</summary>
    /// <param name="trajectory">The positions of the camera, or of the body that carries several.</param>
    /// <param name="cameras">The run's other settings: those of each camera.</param>
    /// <param name="ephemeris">Opened if the states or the Sun need it.</param>
    /// <exception cref="MsisfException">The run can't be made.</exception>
    public static PreparedRun Of(
        TrajectorySettings trajectory, IReadOnlyList<RenderSettings> cameras, EphemerisSource ephemeris, ProgramHost host,
        CancellationToken cancellation)
    {
        ModelOnDemand model = new(cameras[0], host, cancellation);
        try
        {
            IReadOnlyList<RunFrames> run = RunFrames.Read(trajectory, cameras, ephemeris, model, host, cancellation);
            foreach (RunFrames camera in run)
            {
                GroundCheck.Refuse(
                    camera.Frames, model.Opened, camera.Settings.ShutterSpan, cancellation, camera.Settings.Body, trajectory);
                camera.WarnOfCamera(host, model.Opened.Grid.ReferenceRadius);
            }

            return new PreparedRun(run, model.Opened)
            {
                Orientation = cameras[0].IsMission ? ephemeris.Orientation : null,
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
