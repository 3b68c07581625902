using Msisf.App.Host;
using Msisf.App.Preview;
using Msisf.App.Rendering;
using Msisf.App.Settings;
using Msisf.Cli.Output;

namespace Msisf.Cli.Commands;

/// <summary><c>msis</c> without a command: renders a run, or tells what it would show.</summary>
internal static class RenderCommand
{
    public static async Task<int> RunAsync(CommandCall call, CancellationToken cancellation)
    {
        TrajectorySettings trajectory = TrajectorySettingsReader.Read(call.Values);
        IReadOnlyList<RenderSettings> cameras = RigOptions.Read(call.Values, call.Host.GeoTiffs);
        RenderSettings settings = cameras[0];
        if (DryRunOptions.Read(call.Values) is { } format)
        {
            PreviewPrinter.Print(
                await Task.Run(() => DryRun.Of(trajectory, cameras, call.Host, cancellation), cancellation).ConfigureAwait(false),
                format,
                call.Host.Results);
            PrintTimes(settings, call.Host, []);
            return 0;
        }

        if (settings.ListPatterns)
        {
            PatternList.Print(trajectory, settings, call.Host, cancellation);
            return 0;
        }

        IReadOnlyList<FrameOutputs> outputs = await RenderRun.RunAsync(trajectory, cameras, call.Host, cancellation).ConfigureAwait(false);
        PrintTimes(settings, call.Host, outputs);
        return 0;
    }

    private static void PrintTimes(RenderSettings settings, ProgramHost host, IReadOnlyList<FrameOutputs> outputs)
    {
        if (settings.Timing)
        {
            host.Log.Raw(TimingReport.Of(host.Times, outputs));
        }
    }
}
