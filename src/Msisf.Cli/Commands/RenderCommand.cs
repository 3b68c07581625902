using Msisf.App.Preparation;
using Msisf.App.Rendering;
using Msisf.App.Settings;

namespace Msisf.Cli.Commands;

/// <summary>The program's main job: <c>msis</c> without a command.</summary>
internal static class RenderCommand
{
    /// <summary>Does it.</summary>
    public static async Task<int> RunAsync(CommandCall call, CancellationToken cancellation)
    {
        CameraSettings camera = CameraSettingsReader.Read(call.Values);
        using RenderRun rendering = new(RenderSettingsReader.Read(call.Values), call.Host);
        StateSource states = new(rendering.Ephemeris, call.Host);
        await rendering.RunAsync(() => states.Read(camera, cancellation), cancellation).ConfigureAwait(false);
        return 0;
    }
}
