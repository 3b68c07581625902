using System.Globalization;
using Msisf.Adapters.Cluster;
using Msisf.App.Cluster;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.Core.Errors;

namespace Msisf.Cli.Commands;

/// <summary><c>msis submit</c>: gives a run to Slurm, and follows it if asked to.</summary>
internal static class SubmitCommand
{
    private static readonly TimeSpan Pause = TimeSpan.FromSeconds(5);

    /// <summary>Network file systems show what another node wrote up to a minute late.</summary>
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(3);

    /// <summary>Does it.</summary>
    public static async Task<int> RunAsync(CommandCall call, CancellationToken cancellation)
    {
        ProgramHost host = call.Host;
        SlurmProgram slurm = new(host.Environment("PATH") ?? string.Empty);
        if (!slurm.Has("sbatch"))
        {
            throw new ExternalPartException("no sbatch on the PATH: this computer gives no jobs to Slurm. Call msis submit on a login node of the cluster, or use msis batchconvert with --format parallel or sh.");
        }

        ConvertedRun run = new RunConversion(host).Convert(
            call.Values, call.Words, ScriptFormat.Slurm, settings => Path.Combine(settings.OutputFolder, ScriptOptions.SlurmScriptName), cancellation);
        host.Log.Note(string.Create(CultureInfo.InvariantCulture, $"{run.FrameCount} frames in {run.PieceCount} pieces, {run.Script}."));
        ProcessResult answer = await slurm.CallAsync("sh", [run.Script], cancellation).ConfigureAwait(false);
        host.Results.Write(answer.Output);
        if (answer.ExitCode != 0)
        {
            throw new ExternalPartException($"Slurm takes no job: {answer.Error.Trim().ReplaceLineEndings(" ")}");
        }

        if (!ScriptOptions.Wait.Read(call.Values))
        {
            return 0;
        }

        int code = await new SlurmWatch(run, slurm, host, Pause, Patience).FollowAsync(cancellation).ConfigureAwait(false);
        if (code == 0)
        {
            host.Log.Note($"{run.FrameCount} frames are there and right.");
        }
        else
        {
            host.Log.Error(code == CheckCommand.ExitNotComplete
                ? $"frames are missing after all retries: {run.Script}.missing lists them, the logs in {run.Script}.logs say why."
                : string.Create(CultureInfo.InvariantCulture, $"the last job ended with exit code {code}: see the logs in {run.Script}.logs."));
        }

        return code;
    }
}
