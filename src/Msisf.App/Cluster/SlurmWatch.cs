using System.Security.Cryptography;
using System.Text;
using Msisf.Adapters.Cluster;
using Msisf.Adapters.Manifest;
using Msisf.Adapters.Programs;
using Msisf.App.Host;

namespace Msisf.App.Cluster;

/// <summary>
/// Follows submitted jobs to their end. The manifest says which frames are done, and the script's result file says how the run ended. Slurm
/// is only asked whether jobs remain, and may be unavailable for a while.
/// </summary>
internal sealed class SlurmWatch
{
    private readonly ConvertedRun _run;
    private readonly SlurmProgram _slurm;
    private readonly ProgramHost _host;
    private readonly TimeSpan _pause;
    private readonly TimeSpan _patience;
    private int _lastDone = -1;

    /// <summary>Prepares to follow the jobs of a script.</summary>
    /// <param name="run">The run whose script was submitted.</param>
    /// <param name="slurm">Calls the commands of Slurm.</param>
    /// <param name="pause">Time between two checks.</param>
    /// <param name="patience">How long to wait for the result after all jobs ended, because files of other nodes may appear late.</param>
    public SlurmWatch(ConvertedRun run, SlurmProgram slurm, ProgramHost host, TimeSpan pause, TimeSpan patience) =>
        (_run, _slurm, _host, _pause, _patience) = (run, slurm, host, pause, patience);

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
            _host.Log.Note(
                $"no longer followed; the jobs go on. msis status {PosixWord.Of(_run.OutputFolder)} says how far they are, "
                    + $"scancel --name={SlurmJobName.Of(_run.Script)} ends them.");
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
        using ManifestReader manifest = new(new ManifestFile(_run.OutputFolder));
        long start = _host.Clock.GetTimestamp();
        long lastSeen = start;
        int before = CountDone(manifest);
        while (true)
        {
            if (Result() is int code)
            {
                return code;
            }

            Tell(CountDone(manifest), before, _host.Clock.GetElapsedTime(start));
            ProcessResult jobs = await _slurm.CallAsync(
                "squeue", ["--noheader", $"--name={SlurmJobName.Of(_run.Script)}", "--format=%i"], cancellation).ConfigureAwait(false);
            if (jobs.ExitCode != 0 || !string.IsNullOrWhiteSpace(jobs.Output))
            {
                lastSeen = _host.Clock.GetTimestamp();
            }
            else if (_host.Clock.GetElapsedTime(lastSeen) > _patience && Result() is null)
            {
                throw new ExternalPartException(
                    $"all jobs are gone, and none said how it ended; their logs are in {_run.Script}.logs. Run the same call again: "
                        + $"it makes what is missing.");
            }

            await Task.Delay(_pause, _host.Clock, cancellation).ConfigureAwait(false);
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
            ? Invariant($", {rate:0.##} a second, {TimeSpan.FromSeconds(Math.Round((_run.FrameCount - done) / rate)):c} left")
            : string.Empty;
        _host.Log.Note(Invariant($"{done} of {_run.FrameCount} frames{left}"));
    }

    private int? Result()
    {
        try
        {
            return int.TryParse(
                File.ReadAllText($"{_run.Script}.result").Trim(),
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
