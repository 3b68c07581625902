using Msisf.App.Cluster;
using Msisf.App.Settings;

namespace Msisf.Cli.Commands;

/// <summary><c>msis submit</c>: submits a run to Slurm, and follows its jobs if requested.</summary>
internal static class SubmitCommand
{
    public static async Task<int> RunAsync(CommandCall call, CancellationToken cancellation)
    {
        RunSubmission submission = await RunSubmission.SubmitAsync(call.Values, call.Words, call.Host, cancellation).ConfigureAwait(false);
        if (!ScriptOptions.Wait.Read(call.Values))
        {
            return 0;
        }

        ConvertedRun run = submission.Run;
        int code = await submission.FollowAsync(cancellation).ConfigureAwait(false);
        if (code == 0)
        {
            call.Host.Log.Note($"{run.FrameCount} frames are there and complete.");
        }
        else
        {
            call.Host.Log.Error(code == CheckCommand.ExitNotComplete
                ? $"frames are missing after all retries: {run.Script}.missing lists them, the logs in {run.Script}.logs say why."
                : Invariant($"the last job ended with exit code {code}: see the logs in {run.Script}.logs."));
        }

        return code;
    }
}
