using Msisf.Adapters.Tiles;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Tiles;
using Msisf.Core.Tiles.Selection;

namespace Msisf.App.Rendering;

/// <summary>Makes patterns before a run; patterns that exist and are complete are kept.</summary>
internal static class PatternRun
{
    /// <summary>Makes the meshes that the POV-Ray frames of a run include.</summary>
    /// <returns>Folder of the patterns.</returns>
    /// <exception cref="MsisfException">The run could not be made, or a pattern can't be written.</exception>
    public static async Task<string> MakeForFramesAsync(
        TrajectorySettings trajectory, RenderSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        using EphemerisSource ephemeris = new(settings, host);
        using PreparedRun run = PreparedRun.Of(trajectory, [settings], ephemeris, host, cancellation);
        using ISceneSurface surface = SceneSurfaces.Of(run.Model, settings);
        int made = 0;
        using (IRunProgress progress = host.Progress.Start("Patterns of frames", run.Frames.Count, settings.Unattended))
        {
            ParallelOptions parallel =
                new() { MaxDegreeOfParallelism = settings.Jobs ?? Environment.ProcessorCount, CancellationToken = cancellation };
            await Parallel.ForEachAsync(run.Frames, parallel, (frame, stop) =>
            {
                Interlocked.Add(ref made, surface.Select(frame, threads: 1, stop).Ensure(stop));
                progress.Advance(frame.Name);
                return ValueTask.CompletedTask;
            }).ConfigureAwait(false);
        }

        host.Log.Note($"{made} of {surface.Count} patterns made, the others were there.");
        return surface.Folder;
    }

    /// <param name="settings">Selects the model and the form of the patterns.</param>
    /// <returns>Folder of the patterns.</returns>
    /// <exception cref="MsisfException">There is no such model, or a pattern can't be written.</exception>
    public static string MakeForWholeMoon(WholeMoonSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        using GridSource source = GridSource.Open(settings, host, cancellation);
        using PatternRepository repository = new(settings.PatternRepository);
        using IRunProgress progress = host.Progress.Start("Patterns", TileId.Count, settings.Unattended);
        PatternSet set = repository.EnsurePatterns(
            TileId.All, source.Grid, settings.Patterns, Environment.ProcessorCount, new TileProgress(progress), cancellation);
        host.Log.Note($"{set.Written} of {set.Paths.Count} patterns made, the others were there.");
        return repository.FolderOf(source.Grid.PixelsPerDegree);
    }

    /// <summary>Reports each tile at once, on the thread that made it.</summary>
    private sealed class TileProgress(IRunProgress progress) : IProgress<int>
    {
        public void Report(int value) => progress.Advance("tiles");
    }
}

/// <summary>Lists the tiles that the frames of a run use or leave out, with reasons.</summary>
internal static class PatternList
{
    /// <summary>Prints one line for each tile of each frame: step, tile, taken or not, reason; separated by tabs.</summary>
    public static void Print(TrajectorySettings trajectory, RenderSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        using EphemerisSource ephemeris = new(settings, host);
        using PreparedRun run = PreparedRun.Of(trajectory, [settings], ephemeris, host, cancellation);
        foreach (Frame frame in run.Frames)
        {
            cancellation.ThrowIfCancellationRequested();
            TileSelection tiles = run.Model.Select(frame, Environment.ProcessorCount, cancellation);
            foreach (TileChoice choice in tiles.WithRays(SphereRays.TilesOf(frame.Camera)).All)
            {
                host.Results.WriteLine(Invariant(
                    $"{frame.Step}\t{choice.Tile.RangeText}\t{(choice.IsKept ? "taken" : "left out")}\t{choice.ReasonText}"));
            }
        }
    }
}
