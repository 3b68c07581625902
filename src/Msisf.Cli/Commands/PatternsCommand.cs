using Msisf.Adapters.Tiles;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Rendering;
using Msisf.App.Settings;
using Msisf.Core.Tiles;

namespace Msisf.Cli.Commands;

/// <summary><c>msis patterns</c>: makes patterns ahead of time, those of a whole Moon or those that the frames of a run need.</summary>
internal static class PatternsCommand
{
    /// <summary>Does it.</summary>
    public static async Task<int> RunAsync(CommandCall call, CancellationToken cancellation)
    {
        string folder = PatternsOptions.ReadRun(call.Values) is (CameraSettings camera, RenderSettings settings)
            ? await MakeOfRunAsync(camera, settings, call.Host, cancellation).ConfigureAwait(false)
            : await Task.Run(() => MakeOfWholeMoon(PatternsOptions.ReadWholeMoon(call.Values), call.Host, cancellation), cancellation).ConfigureAwait(false);
        call.Host.Results.WriteLine(folder);
        return 0;
    }

    private static async Task<string> MakeOfRunAsync(CameraSettings camera, RenderSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        using EphemerisSource ephemeris = new(settings, host);
        StateSource states = new(ephemeris.Engine, host);
        return await new PatternRun(settings, ephemeris, host).RunAsync(states.Read(camera, cancellation), cancellation).ConfigureAwait(false);
    }

    private static string MakeOfWholeMoon(WholeMoonSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        using GridSource grid = GridSource.Open(settings, host);
        using PatternRepository repository = new(settings.PatternRepository);
        using IRunProgress progress = host.Progress.Start("Patterns", TileId.Count, settings.Unattended);
        PatternSet made = repository.EnsurePatterns(
            TileId.All, grid.Grid, settings.Patterns, Environment.ProcessorCount, new StepProgress(progress), cancellation);
        host.Log.Note($"{made.Written} of {made.Paths.Count} patterns made, the others were there.");
        return repository.FolderOf(grid.Grid.PixelsPerDegree);
    }

    /// <summary>Passes each ready tile on at once, on the thread that made it.</summary>
    private sealed class StepProgress(IRunProgress progress) : IProgress<int>
    {
        public void Report(int value) => progress.Advance("tiles");
    }
}
