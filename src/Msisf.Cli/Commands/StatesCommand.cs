using Msisf.App.Settings;
using Msisf.App.States;

namespace Msisf.Cli.Commands;

/// <summary><c>msis states</c>: writes the states of a run for other programs.</summary>
internal static class StatesCommand
{
    public static int Run(CommandCall call, CancellationToken cancellation)
    {
        StatesFormat format = StatesOptions.Format.Read(call.Values);
        string? path = StatesOptions.ReadPath(call.Values);
        TrajectorySettings trajectory = TrajectorySettingsReader.Read(call.Values);
        IReadOnlyList<RenderSettings> cameras = RigOptions.Read(call.Values, call.Host.GeoTiffs);
        foreach (RenderSettings camera in cameras)
        {
            StatesExport.Write(trajectory, camera, format, RigOptions.PathOf(path, camera.Rig), call.Host, cancellation);
        }

        return 0;
    }
}
