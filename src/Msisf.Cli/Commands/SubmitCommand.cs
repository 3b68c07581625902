using System.CommandLine;
using System.Globalization;
using Msisf.Adapters.Cluster;
using Msisf.Adapters.Programs;
using Msisf.App.Cluster;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.Cli.Options;
using Msisf.Cli.Pieces;
using Msisf.Core.Errors;

namespace Msisf.Cli.Commands;

/// <summary><c>msis submit</c>: gives a run to Slurm, and follows it if asked to.</summary>
internal static class SubmitCommand
{
    /// <summary>In the folder of the outputs.</summary>
    private const string ScriptName = "msis-pieces.slurm.sh";

    private static readonly TimeSpan Pause = TimeSpan.FromSeconds(5);

    /// <summary>Network file systems show what another node wrote up to a minute late.</summary>
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(3);

    /// <summary>Declares the command and its options.</summary>
    public static Command Create(ProgramHost host)
    {
        RenderOptions run = new();
        CutOptions cut = new();
        SlurmOptions slurm = new();
        Option<bool> wait = OptionFactory.Flag("--wait", [], "Tell the progress, and end with the exit code of the whole");
        Command command = new(
            "submit",
            $"Gives a run to Slurm in pieces: msis batchconvert --format slurm into the folder of the outputs ({ScriptName}), "
                + $"and its submission.");
        foreach (Option option in (Option[])[.. cut.All, wait, .. slurm.All, .. run.All])
        {
            command.Options.Add(option);
        }

        RunConversion conversion = new(run, cut, slurm, host);
        command.SetAction(
            (line, cancellation) => Task.Run(() => SubmitAsync(line, conversion, line.GetValue(wait), host, cancellation), cancellation));
        return command;
    }

    private static async Task<int> SubmitAsync(
        ParseResult line, RunConversion conversion, bool wait, ProgramHost host, CancellationToken cancellation)
    {
        SlurmProgram slurm = new(host.Environment("PATH") ?? string.Empty);
        if (!slurm.Has("sbatch"))
        {
            throw new ExternalPartException(
                "no sbatch on the PATH: this computer gives no jobs to Slurm. "
                    + "Call msis submit on a login node of the cluster, or use msis batchconvert with --format parallel or sh.");
        }

        ConvertedRun run = conversion.Convert(
            line, ScriptFormat.Slurm, settings => Path.Combine(settings.OutputFolder, ScriptName), cancellation);
        host.Log.Note(string.Create(CultureInfo.InvariantCulture, $"{run.FrameCount} frames in {run.PieceCount} pieces, {run.Script}."));
        ProcessResult answer = await slurm.CallAsync("sh", [run.Script], cancellation).ConfigureAwait(false);
        host.Results.Write(answer.Output);
        if (answer.ExitCode != 0)
        {
            throw new ExternalPartException($"Slurm takes no job: {answer.Error.Trim().ReplaceLineEndings(" ")}");
        }

        if (!wait)
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
                : string.Create(
                    CultureInfo.InvariantCulture, $"the last job ended with exit code {code}: see the logs in {run.Script}.logs."));
        }

        return code;
    }
}
