using System.CommandLine;
using System.Text;
using Msisf.Adapters.IO;
using Msisf.Adapters.Input;
using Msisf.App.Cluster;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Cli.Options;
using Msisf.Core.Errors;
using Msisf.Core.Render;
using Msisf.Core.Scene;

namespace Msisf.Cli.Pieces;

/// <summary>Turns a run into a script that makes it in pieces.</summary>
internal sealed class RunConversion
{
    /// <summary>Characters of the call in the head of a script: enough for any but one with a long list of times.</summary>
    private const int LongestCall = 2000;

    private readonly RenderOptions _options;
    private readonly CutOptions _cut;
    private readonly SlurmOptions _slurm;
    private readonly ProgramHost _host;

    public RunConversion(RenderOptions options, CutOptions cut, SlurmOptions slurm, ProgramHost host) =>
        (_options, _cut, _slurm, _host) = (options, cut, slurm, host);

    /// <summary>Checks the run, cuts it, and writes the script with what it needs beside it.</summary>
    /// <param name="line">The options of all.</param>
    /// <param name="format">For whom.</param>
    /// <param name="scriptPath">The script, by the folder of the outputs; folders of it that are not there are made.</param>
    /// <param name="cancellation">Ends it and leaves no file.</param>
    /// <exception cref="MsisfException">What the run would refuse is refused here, before anything is written.</exception>
    public ConvertedRun Convert(
        ParseResult line, ScriptFormat format, Func<RenderSettings, string> scriptPath, CancellationToken cancellation)
    {
        CutSettings cut = _cut.Read(line);
        SlurmSettings? slurm = format == ScriptFormat.Slurm ? _slurm.Read(line) : null;
        PieceArguments arguments = new(line, _options, endsWithCheck: format is ScriptFormat.Parallel or ScriptFormat.Slurm);
        using PlannedRun run = RunPlanner.Plan(line, _options, _host, cancellation);
        CheckResources(run, slurm);
        string path = Path.GetFullPath(scriptPath(run.Settings));
        string? statesFile = run.Mode == Mode.BatchFile ? null : $"{path}.states.tab";
        string batchFile = statesFile ?? line.GetValue(_options.Mode.BatchFile)!;
        PieceScript script = new()
        {
            Path = path,
            Call = CallOf(line),
            Version = _host.Version,
            Launcher = _host.Installation.Launcher,
            WorkingFolder = Directory.GetCurrentDirectory(),
            Arguments = arguments.OfPiece(batchFile, run.Engine),
            HasJobs = run.Settings.Jobs is not null,
            NeedsPatterns = run.Settings.Renderer == RendererKind.PovRay,
            PatternArguments = arguments.OfPatterns(batchFile, run.Engine),
            OutputFolder = run.Settings.OutputFolder,
            Pieces = Cut(run, cut),
        };
        string text = slurm is null ? ScriptText.Of(format, script) : ScriptText.Slurm(script, slurm);
        Write(script, text, statesFile, run.States, hasLogs: slurm is not null);
        return new ConvertedRun(path, statesFile, run.Settings.OutputFolder, run.Frames.Count, script.Pieces.Count);
    }

    private static IReadOnlyList<StepRanges> Cut(PlannedRun run, CutSettings cut)
    {
        int[] steps = [.. run.Frames.Select(frame => frame.Step)];
        return cut.FramesPerPiece is int size ? RunCutter.BySize(steps, size) : RunCutter.ByCount(steps, cut.Pieces!.Value);
    }

    private static string CallOf(ParseResult line)
    {
        string words = string.Join(' ', line.Tokens.Select(token => PosixWord.Of(token.Value)));
        string call = string.Concat(words.Select(character => char.IsControl(character) ? '?' : character));
        return call.Length <= LongestCall ? call : $"{call[..LongestCall]}...";
    }

    /// <summary>Refuses what a piece would refuse for want of memory, and what the whole run would need of the disk.</summary>
    private static void CheckResources(PlannedRun run, SlurmSettings? slurm)
    {
        int atOnce = run.Settings.Jobs ?? slurm?.CpusPerTask ?? 1;
        string folder = Path.GetFullPath(run.Settings.OutputFolder);
        while (!Directory.Exists(folder))
        {
            folder = Path.GetDirectoryName(folder)!;
        }

        ResourceCheck.Check(
            run.Settings, run.Frames.Count, atOnce, slurm?.MemoryBytes ?? long.MaxValue, new DriveInfo(folder).AvailableFreeSpace);
    }

    private static void Write(PieceScript script, string text, string? statesFile, IReadOnlyList<SpacecraftState> states, bool hasLogs)
    {
        FileErrors.ToExternalPart($"{script.Path}: the script can't be written there", () =>
        {
            Directory.CreateDirectory(Path.GetDirectoryName(script.Path)!);
            if (hasLogs)
            {
                Directory.CreateDirectory($"{script.Path}.logs");
            }

            // It counts the pieces of the script before: GNU parallel would leave out others.
            File.Delete($"{script.Path}.joblog");
        });

        if (statesFile is not null)
        {
            AtomicFile.WriteText(
                statesFile, writer => BatchFileWriter.Write(writer, $"Made by msis {script.Version}: msis {script.Call}", states));
        }

        AtomicFile.Write(script.Path, stream => stream.Write(Encoding.UTF8.GetBytes(text)));
    }
}
