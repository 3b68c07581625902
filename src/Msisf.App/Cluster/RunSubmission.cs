using System.Globalization;
using Msisf.Adapters.Cluster;
using Msisf.Adapters.Programs;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Errors;

namespace Msisf.App.Cluster;

/// <summary>A run that was given to Slurm in pieces.</summary>
internal sealed class RunSubmission
{
    private static readonly TimeSpan Pause = TimeSpan.FromSeconds(5);

    /// <summary>Network file systems show what another node wrote up to a minute late.</summary>
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(3);

    private readonly SlurmProgram _slurm;
    private readonly ProgramHost _host;

    private RunSubmission(ConvertedRun run, SlurmProgram slurm, ProgramHost host) => (Run, _slurm, _host) = (run, slurm, host);

    /// <summary>The run and its script, in the folder of the outputs.</summary>
    public ConvertedRun Run { get; }

    /// <summary>Checks the run, writes its script and submits that; the host's results get what Slurm says.</summary>
    /// <param name="values">The options of the run, of the pieces, and of Slurm.</param>
    /// <param name="call">The words of the call, for the head of the script.</param>
    /// <param name="host">The world.</param>
    /// <param name="cancellation">Ends it.</param>
    /// <exception cref="MsisfException">The run could not be made, or Slurm is missing or takes no job.</exception>
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
        host.Log.Note(string.Create(CultureInfo.InvariantCulture, $"{run.FrameCount} frames in {run.PieceCount} pieces, {run.Script}."));
        ProcessResult answer = await slurm.CallAsync("sh", [run.Script], cancellation).ConfigureAwait(false);
        host.Results.Write(answer.Output);
        return answer.ExitCode == 0
            ? new RunSubmission(run, slurm, host)
            : throw new ExternalPartException($"Slurm takes no job: {answer.Error.Trim().ReplaceLineEndings(" ")}");
    }

    /// <summary>Tells the progress until the end.</summary>
    /// <returns>The exit code of the whole.</returns>
    /// <exception cref="ExternalPartException">All jobs are gone, and none said how it ended.</exception>
    public Task<int> FollowAsync(CancellationToken cancellation) =>
        new SlurmWatch(Run, _slurm, _host, Pause, Patience).FollowAsync(cancellation);
}
