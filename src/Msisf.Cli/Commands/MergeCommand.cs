using Msisf.App.Series;
using Msisf.App.Settings;

namespace Msisf.Cli.Commands;

/// <summary><c>msis merge</c>: does the final work when all pieces of a run are done.</summary>
internal static class MergeCommand
{
    public static async Task<int> RunAsync(CommandCall call, CancellationToken cancellation)
    {
        string folder = call.Values.Argument!;
        SeriesStatus status = await SeriesMerge.RunAsync(
            folder, FolderOptions.ReadMerge(call.Values), call.Host, cancellation).ConfigureAwait(false);
        if (status.IsComplete)
        {
            return 0;
        }

        call.Host.Log.Warning(
            $"{status.Incomplete.Count()} of {status.Frames.Count} frames are not complete; msis status {folder} names them.");
        return CheckCommand.ExitNotComplete;
    }
}
