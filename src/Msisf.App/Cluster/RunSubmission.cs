using System.Security.Cryptography;
using System.Text;
using Msisf.Adapters.Cluster;
using Msisf.Adapters.Manifest;
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

/// <summary>
/// Follows submitted jobs to their end. The manifest says which frames are done, and the script's result file says how the run ended. Slurm
/// is only asked whether jobs remain, and may be unavailable for a while.
/// </summary>
/// <param name="run">The run whose script was submitted.</param>
/// <param name="slurm">Calls the commands of Slurm.</param>
/// <param name="pause">Time between two checks.</param>
/// <param name="patience">How long to wait for the result after all jobs ended, because files of other nodes may appear late.</param>
internal sealed class SlurmWatch(ConvertedRun run, SlurmProgram slurm, ProgramHost host, TimeSpan pause, TimeSpan patience)
{
    private int _lastDone = -1;

    /// <summary>Reports the progress until all jobs have ended.</summary>
    /// <returns>The exit code of the whole run.</returns>
    /// <exception cref="ExternalPartException">All jobs have ended, and no job wrote a result.</exception>
    public async Task<int> FollowAsync(CancellationToken cancellation)
    {
        try
        {
            return await FollowToTheEndAsync(cancellation).ConfigureAwait(false);
        }
        catch (OperationCanceledException)
        {
            host.Log.Note(
                $"no longer followed; the jobs go on. msis status {PosixWord.Of(run.OutputFolder)} says how far they are, "
                    + $"scancel --name={SlurmJobName.Of(run.Script)} ends them.");
            throw;
        }
    }

    private static int CountDone(ManifestReader manifest)
    {
        manifest.Refresh();
        ManifestContent content = manifest.Content;
        return content.Expected.Values.Count(expected =>
            expected.Run == content.LastRun && content.Frames.TryGetValue(expected.Name, out FrameRecord? made)
                && made.Frame == expected.Frame);
    }

    private async Task<int> FollowToTheEndAsync(CancellationToken cancellation)
    {
        using ManifestReader manifest = new(new ManifestFile(run.OutputFolder));
        long start = host.Clock.GetTimestamp();
        long lastSeen = start;
        int before = CountDone(manifest);
        while (true)
        {
            if (Result() is int code)
            {
                return code;
            }

            Tell(CountDone(manifest), before, host.Clock.GetElapsedTime(start));
            ProcessResult jobs = await slurm.CallAsync(
                "squeue", ["--noheader", $"--name={SlurmJobName.Of(run.Script)}", "--format=%i"], cancellation).ConfigureAwait(false);
            if (jobs.ExitCode != 0 || !string.IsNullOrWhiteSpace(jobs.Output))
            {
                lastSeen = host.Clock.GetTimestamp();
            }
            else if (host.Clock.GetElapsedTime(lastSeen) > patience && Result() is null)
            {
                throw new ExternalPartException(
                    $"all jobs are gone, and none said how it ended; their logs are in {run.Script}.logs. Run the same call again: "
                        + $"it makes what is missing.");
            }

            await Task.Delay(pause, host.Clock, cancellation).ConfigureAwait(false);
        }
    }

    private void Tell(int done, int before, TimeSpan time)
    {
        if (done == _lastDone)
        {
            return;
        }

        _lastDone = done;
        double rate = (done - before) / time.TotalSeconds;
        string left = rate > 0.0
            ? Invariant($", {rate:0.##} a second, {TimeSpan.FromSeconds(Math.Round((run.FrameCount - done) / rate)):c} left")
            : string.Empty;
        host.Log.Note(Invariant($"{done} of {run.FrameCount} frames{left}"));
    }

    private int? Result()
    {
        try
        {
            return int.TryParse(
                File.ReadAllText($"{run.Script}.result").Trim(),
                NumberStyles.None,
                CultureInfo.InvariantCulture,
                out int code) ? code : null;
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return null; // not there yet
        }
    }
}

/// <summary>
/// The name of a script's jobs: all jobs of a script share it and other scripts have other names, so that squeue can select them.
/// </summary>
internal static class SlurmJobName
{
    /// <summary>"msis-" and eight digits of the path's checksum.</summary>
    /// <param name="scriptPath">Full path.</param>
    public static string Of(string scriptPath) =>
        $"msis-{Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(scriptPath)))[..8]}";
}
