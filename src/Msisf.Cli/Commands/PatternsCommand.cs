using System.CommandLine;
using Msisf.Adapters.Tiles;
using Msisf.Cli.Options;
using Msisf.Cli.Progress;
using Msisf.Cli.Run;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Cli.Commands;

/// <summary>Makes the patterns of a whole Moon ahead of time.</summary>
internal static class PatternsCommand
{
    /// <summary>Declares the command and its options.</summary>
    public static Command Create(ProgramHost host)
    {
        SourceOptions source = new();
        DatabaseOptions database = new();
        Option<string?> margin = OptionFactory.Value(
            "--margin", [], "DEGREES", "Overlap with the neighbours, for scenes of 2012; none is needed (default 0, at most 1)");
        Option<string?> format = OptionFactory.Value(
            "--format", [], "mesh2|mesh", "Form of the patterns: exact and compact (default), or the thesis's text form for old scenes");
        Option<bool> batch = OptionFactory.Flag("--batch", ["-b"], "Unattended: draw no progress bar");
        Command command = new("patterns", "Makes all 2,592 surface patterns of an elevation model; those that are there and right are kept.");
        foreach (Option option in (Option[])[.. source.All, .. database.All, margin, format, batch])
        {
            command.Options.Add(option);
        }

        command.SetAction((line, cancellation) => Task.Run(
            () =>
            {
                StrayOptions.Refuse(line);
                double marginDegrees = line.GetValue(margin) is string degrees ? OptionText.Number(margin, degrees) : 0.0;
                PatternFormat form = line.GetValue(format) is string name
                    ? OptionText.Choice(format, name, [("mesh2", PatternFormat.Mesh2), ("mesh", PatternFormat.Mesh)])
                    : PatternFormat.Mesh2;
                PatternOptions options = OptionText.Named(margin, () => new PatternOptions(marginDegrees, form));
                using GridSource grid = GridSource.Open(line, source, database, host);
                Make(line, source, grid.Grid, options, line.GetValue(batch), host, cancellation);
                return 0;
            },
            cancellation));
        return command;
    }

    private static void Make(
        ParseResult line, SourceOptions source, IElevationGrid grid, PatternOptions options, bool unattended, ProgramHost host, CancellationToken cancellation)
    {
        string root = line.GetValue(source.PatternRepository) is string folder
            ? OptionText.FilePath(source.PatternRepository, folder)
            : SourceSettings.DefaultRepository;
        using PatternRepository repository = new(root);
        using IRunProgress progress = RunProgress.Start("Patterns", TileId.Count, unattended, host.Log, host.Clock);
        PatternSet made = repository.EnsurePatterns(
            TileId.All, grid, options, Environment.ProcessorCount, new StepProgress(progress), cancellation);
        host.Log.Note($"{made.Written} of {made.Paths.Count} patterns made, the others were there.");
        host.Results.WriteLine(repository.FolderOf(grid.PixelsPerDegree));
    }

    /// <summary>Passes each ready tile on at once, on the thread that made it.</summary>
    private sealed class StepProgress(IRunProgress progress) : IProgress<int>
    {
        public void Report(int value) => progress.Advance("tiles");
    }
}
