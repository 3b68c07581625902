using Msisf.App.Settings;
using Msisf.App.States;

namespace Msisf.Cli.Commands;

/// <summary><c>msis states</c>: writes the states of a run for other programs.</summary>
internal static class StatesCommand
{
    /// <summary>Runs the command.</summary>
    public static int Run(CommandCall call, CancellationToken cancellation)
    {
        StatesFormat format = StatesOptions.Format.Read(call.Values);
        string? path = StatesOptions.ReadPath(call.Values);
        TrajectorySettings trajectory = TrajectorySettingsReader.Read(call.Values);
        RenderSettings settings = RenderSettingsReader.Read(call.Values, geoTiffs: call.Host.GeoTiffs);
        StatesExport.Write(trajectory, settings, format, path, call.Host, cancellation);
        return 0;
    }
}
