using System.CommandLine;
using Msisf.Adapters.Tiles;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Rendering;
using Msisf.App.Settings;
using Msisf.Cli.Options;
using Msisf.Cli.Pieces;
using Msisf.Core.Tiles;

namespace Msisf.Cli.Commands;

/// <summary>Makes patterns ahead of time: those of a whole Moon, or those that the frames of a run need.</summary>
internal sealed class PatternsCommand
{
    private readonly SourceOptions _source = new();
    private readonly DatabaseOptions _database = new();
    private readonly ForBatchOptions _ofRun = new();

    private readonly Option<string?> _margin = OptionFactory.Value(
        "--margin", [], "DEGREES", "Overlap with the neighbours, for scenes of 2012; none is needed (default 0, at most 1)");

    private readonly Option<string?> _format = OptionFactory.Value(
        "--format", [], "mesh2|mesh", "Form of the patterns: exact and compact (default), or the thesis's text form for old scenes");

    private readonly Option<bool> _batch;
    private readonly ProgramHost _host;

    private PatternsCommand(ProgramHost host)
    {
        _host = host;
        _batch = _ofRun.Batch;
    }

    /// <summary>Declares the command and its options.</summary>
    public static Command Create(ProgramHost host)
    {
        PatternsCommand patterns = new(host);
        Command command = new(
            "patterns",
            "Makes all 2,592 surface patterns of an elevation model, or what the frames of a run need; "
                + "those that are there and right are kept.");
        Option[] options =
        [
            .. patterns._source.All, .. patterns._database.All, patterns._margin, patterns._format, .. patterns._ofRun.All, patterns._batch,
        ];
        foreach (Option option in options)
        {
            command.Options.Add(option);
        }

        command.SetAction(patterns.RunAsync);
        return command;
    }

    private async Task<int> RunAsync(ParseResult line, CancellationToken cancellation)
    {
        StrayOptions.Refuse(line);
        string folder = _ofRun.Read(line, _source, [.. _database.All, _margin, _format]) is (Mode mode, RenderSettings settings)
            ? await MakeOfRunAsync(line, mode, settings, cancellation).ConfigureAwait(false)
            : await Task.Run(() => MakeOfWholeMoon(line, cancellation), cancellation).ConfigureAwait(false);
        _host.Results.WriteLine(folder);
        return 0;
    }

    private async Task<string> MakeOfRunAsync(ParseResult line, Mode mode, RenderSettings settings, CancellationToken cancellation)
    {
        using EphemerisSource ephemeris = new(settings, _host);
        StateSource states = new(_ofRun.Mode, line, ephemeris.Engine, _host.StandardInput, _host.Log);
        return await new PatternRun(settings, ephemeris, _host).RunAsync(
            states.Read(mode, cancellation), cancellation).ConfigureAwait(false);
    }

    private string MakeOfWholeMoon(ParseResult line, CancellationToken cancellation)
    {
        double marginDegrees = line.GetValue(_margin) is string degrees ? OptionText.Number(_margin, degrees) : 0.0;
        PatternFormat form = line.GetValue(_format) is string name
            ? OptionText.Choice(_format, name, [("mesh2", PatternFormat.Mesh2), ("mesh", PatternFormat.Mesh)])
            : PatternFormat.Mesh2;
        PatternOptions options = OptionText.Named(_margin, () => new PatternOptions(marginDegrees, form));
        using GridSource grid = GridSource.Open(line, _source, _database, _host);
        string root = line.GetValue(_source.PatternRepository) is string folder
            ? OptionText.FilePath(_source.PatternRepository, folder)
            : SourceSettings.DefaultRepository;
        using PatternRepository repository = new(root);
        using IRunProgress progress = _host.Progress.Start("Patterns", TileId.Count, line.GetValue(_batch));
        PatternSet made = repository.EnsurePatterns(
            TileId.All, grid.Grid, options, Environment.ProcessorCount, new StepProgress(progress), cancellation);
        _host.Log.Note($"{made.Written} of {made.Paths.Count} patterns made, the others were there.");
        return repository.FolderOf(grid.Grid.PixelsPerDegree);
    }

    /// <summary>Passes each ready tile on at once, on the thread that made it.</summary>
    private sealed class StepProgress(IRunProgress progress) : IProgress<int>
    {
        public void Report(int value) => progress.Advance("tiles");
    }
}
