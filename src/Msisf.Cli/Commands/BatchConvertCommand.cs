using System.CommandLine;
using System.Globalization;
using Msisf.App.Cluster;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.Cli.Options;
using Msisf.Cli.Pieces;

namespace Msisf.Cli.Commands;

/// <summary><c>msis batchconvert</c>: turns a run into a script that makes it in pieces.</summary>
internal static class BatchConvertCommand
{
    /// <summary>Declares the command and its options.</summary>
    public static Command Create(ProgramHost host)
    {
        RenderOptions run = new();
        CutOptions cut = new();
        SlurmOptions slurm = new();
        Option<string?> format = OptionFactory.Value(
            "--format", [], "sh|bat|parallel|slurm",
            "Who runs the pieces: a shell or Windows's cmd one after another, GNU parallel, or Slurm");
        Option<string?> script = OptionFactory.Value("--script", [], "FILE", "The script (default ./msis-pieces with the format's ending)");
        format.Required = true;
        Command command = new("batchconvert", "Turns a run into a script that makes it in pieces, on one machine or on many.");
        foreach (Option option in (Option[])[format, .. cut.All, script, .. slurm.All, .. run.All])
        {
            command.Options.Add(option);
        }

        RunConversion conversion = new(run, cut, slurm, host);
        command.SetAction((line, cancellation) => Task.Run(
            () =>
            {
                (ScriptFormat form, string defaultName) = OptionText.Choice(
                    format,
                    line.GetValue(format)!,
                    [
                        ("sh", (ScriptFormat.Sh, "msis-pieces.sh")),
                        ("bat", (ScriptFormat.Bat, "msis-pieces.bat")),
                        ("parallel", (ScriptFormat.Parallel, "msis-pieces.parallel.sh")),
                        ("slurm", (ScriptFormat.Slurm, "msis-pieces.slurm.sh")),
                    ]);
                if (form != ScriptFormat.Slurm)
                {
                    slurm.RefuseWithout(line);
                }

                string path = line.GetValue(script) is string given ? OptionText.FilePath(script, given) : defaultName;
                ConvertedRun converted = conversion.Convert(line, form, _ => path, cancellation);
                host.Log.Note(string.Create(
                    CultureInfo.InvariantCulture, $"{converted.FrameCount} frames in {converted.PieceCount} pieces."));
                host.Results.WriteLine(converted.Script);
                if (converted.StatesFile is not null)
                {
                    host.Results.WriteLine(converted.StatesFile);
                }

                return 0;
            },
            cancellation));
        return command;
    }
}
