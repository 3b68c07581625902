using Msisf.App.Rendering;
using Msisf.App.Settings;

namespace Msisf.Cli.Commands;

/// <summary><c>msis</c> without a command: renders a run.</summary>
internal static class RenderCommand
{
    /// <summary>Runs the command.</summary>
    public static async Task<int> RunAsync(CommandCall call, CancellationToken cancellation)
    {
        CameraSettings camera = CameraSettingsReader.Read(call.Values);
        RenderSettings settings = RenderSettingsReader.Read(call.Values);
        if (settings.ListPatterns)
        {
            PatternList.Print(camera, settings, call.Host, cancellation);
            return 0;
        }

        IReadOnlyList<FrameOutputs> outputs = await RenderRun.RunAsync(camera, settings, call.Host, cancellation).ConfigureAwait(false);
        if (settings.Timing)
        {
            call.Host.Log.Raw(TimingReport.Of(call.Host.Times, outputs));
        }

        return 0;
    }
}
