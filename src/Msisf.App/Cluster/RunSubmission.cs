using Msisf.Adapters.Cluster;
using Msisf.Adapters.Programs;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Cluster;

/// <summary>A run that was submitted to Slurm in pieces.</summary>
internal sealed class RunSubmission
{
    private static readonly TimeSpan Pause = TimeSpan.FromSeconds(5);

    /// <summary>
    /// How long to wait for the result file after all jobs ended; network file systems show another node's files up to a minute late.
    /// </summary>
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(3);

    private readonly SlurmProgram _slurm;
    private readonly ProgramHost _host;

    private RunSubmission(ConvertedRun run, SlurmProgram slurm, ProgramHost host) => (Run, _slurm, _host) = (run, slurm, host);

    /// <summary>The run and its script, which lies in the folder of the outputs.</summary>
    public ConvertedRun Run { get; }

    /// <summary>Checks the run, writes its script and submits it; Slurm's reply is written to the host's results.</summary>
    /// <param name="values">The options of the run, of the pieces, and of Slurm.</param>
    /// <param name="call">The words of the call, for the head of the script.</param>
    /// <exception cref="MsisfException">The run can't be made, Slurm is missing, or Slurm refuses the job.</exception>
    public static async Task<RunSubmission> SubmitAsync(
        OptionValues values, IReadOnlyList<string> call, ProgramHost host, CancellationToken cancellation)
    {
        SlurmProgram slurm = new(host.Environment("PATH") ?? string.Empty);
        if (!slurm.Has("sbatch"))
        {
            throw new ExternalPartException(
                "no sbatch on the PATH: this computer gives no jobs to Slurm. "
                    + "Call msis submit on a login node of the cluster, or use msis batchconvert with --format parallel or sh.");
        }

        ConvertedRun run = new RunConversion(host).Convert(
            values, call, ScriptFormat.Slurm, settings => Path.Combine(settings.OutputFolder, ScriptOptions.SlurmScriptName), cancellation);
        host.Log.Note(Invariant($"{run.FrameCount} frames in {run.PieceCount} pieces, {run.Script}."));
        ProcessResult answer = await slurm.CallAsync("sh", [run.Script], cancellation).ConfigureAwait(false);
        host.Results.Write(answer.Output);
        return answer.ExitCode == 0
            ? new RunSubmission(run, slurm, host)
            : throw new ExternalPartException($"Slurm takes no job: {answer.Error.Trim().ReplaceLineEndings(" ")}");
    }

    /// <summary>Reports the progress until all jobs have ended.</summary>
    /// <returns>The exit code of the whole run.</returns>
    /// <exception cref="ExternalPartException">All jobs have ended, and no job wrote a result.</exception>
    public Task<int> FollowAsync(CancellationToken cancellation) =>
        new SlurmWatch(Run, _slurm, _host, Pause, Patience).FollowAsync(cancellation);
}
