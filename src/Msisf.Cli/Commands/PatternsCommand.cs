using Msisf.App.Rendering;
using Msisf.App.Settings;

namespace Msisf.Cli.Commands;

/// <summary><c>msis patterns</c>: makes patterns before a run, either for the whole Moon or for the frames of a run.</summary>
internal static class PatternsCommand
{
    public static async Task<int> RunAsync(CommandCall call, CancellationToken cancellation)
    {
        string folder = PatternsOptions.ReadRun(call.Values) is (TrajectorySettings trajectory, RenderSettings settings)
            ? await PatternRun.MakeForFramesAsync(trajectory, settings, call.Host, cancellation).ConfigureAwait(false)
            : await Task.Run(
                () => PatternRun.MakeForWholeMoon(PatternsOptions.ReadWholeMoon(call.Values), call.Host, cancellation),
                cancellation).ConfigureAwait(false);
        call.Host.Results.WriteLine(folder);
        return 0;
    }
}
