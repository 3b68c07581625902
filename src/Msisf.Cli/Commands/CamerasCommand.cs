using Msisf.Adapters.Camera;
using Msisf.App.Settings;

namespace Msisf.Cli.Commands;

/// <summary><c>msis cameras</c>: lists the presets of <c>--camera</c>.</summary>
internal static class CamerasCommand
{
    /// <summary>Runs the command.</summary>
    public static void Print(CommandCall call)
    {
        foreach (CameraFile camera in CameraChoice.Presets(call.Host.Installation))
        {
            call.Host.Results.WriteLine(Invariant(
                $"{camera.Name}\t{camera.Model.Width}\t{camera.Model.Height}\t{camera.FieldOfViewDegrees:G6}\t{camera.Description}"));
        }
    }
}
