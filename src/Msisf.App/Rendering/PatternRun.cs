using Msisf.Adapters.Tiles;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Scene;
using Msisf.Core.Tiles;

namespace Msisf.App.Rendering;

/// <summary>
/// Makes ahead of time what POV-Ray's frames of a run need: exactly the meshes that they include, and the summary of the model.
/// </summary>
internal sealed class PatternRun
{
    private readonly RenderSettings _settings;
    private readonly EphemerisSource _ephemeris;
    private readonly ProgramHost _host;

    /// <param name="settings">Of the run.</param>
    /// <param name="ephemeris">Its ephemeris; stays open.</param>
    /// <param name="host">The world.</param>
    public PatternRun(RenderSettings settings, EphemerisSource ephemeris, ProgramHost host)
    {
        _settings = settings;
        _ephemeris = ephemeris;
        _host = host;
    }

    /// <summary>Makes them, for those of the frames that the settings choose.</summary>
    /// <param name="states">Of all frames.</param>
    /// <param name="cancellation">Stops between two patterns.</param>
    /// <returns>Their folder.</returns>
    public async Task<string> RunAsync(IReadOnlyList<SpacecraftState> states, CancellationToken cancellation)
    {
        IReadOnlyList<string> names = new FrameNaming(_settings.OutputName).NamesOf([.. states.Select(state => state.Time)]);
        Frame[] frames = FramePlanner.Plan(states, names, _settings, _ephemeris.Engine, cancellation);
        using ElevationModel model = ElevationModel.Open(_settings.Ldem, _settings.PixelsPerDegree, isSparing: true, _host);
        FramePlanner.RefuseCamerasInTheGround(frames, model, cancellation);
        using ScenePatterns patterns = new(
            new PatternRepository(_settings.PatternRepository), new LevelMeshBuilders(model.Grid, () => model.Levels));
        int made = 0;
        using (IRunProgress progress = _host.Progress.Start("Patterns of frames", frames.Length, _settings.Unattended))
        {
            ParallelOptions parallel =
                new() { MaxDegreeOfParallelism = _settings.Jobs ?? Environment.ProcessorCount, CancellationToken = cancellation };
            await Parallel.ForEachAsync(frames, parallel, (frame, stop) =>
            {
                Interlocked.Add(ref made, patterns.Ensure(model.SelectParts(frame, _settings.LevelOfDetailError), stop));
                progress.Advance(frame.Name);
                return ValueTask.CompletedTask;
            }).ConfigureAwait(false);
        }

        _host.Log.Note($"{made} of {patterns.Count} patterns made, the others were there.");
        return patterns.Folder;
    }
}
