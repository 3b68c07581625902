using System.Diagnostics;
using System.Globalization;
using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Render;
using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Programs;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Tiles;
using Msisf.Core.Tiles.Selection;

namespace Msisf.Benchmarks.Thesis;

/// <summary>
/// Makes one image in the thesis's own way, in a process of its own as msis is one: selection by a ray a pixel, patterns in its text form,
/// POV-Ray with its settings.
/// </summary>
internal static class ThesisFrame
{
    private const string SceneName = "scene.pov";

    /// <summary>Makes the image.</summary>
    /// <param name="job">What.</param>
    /// <param name="ephemeris">For the Sun.</param>
    /// <returns>Times and counts under the names of msis --timing.</returns>
    public static IReadOnlyDictionary<string, double> Run(ThesisFrameJob job, IEphemeris ephemeris)
    {
        using Process self = Process.GetCurrentProcess();
        double startUp = (DateTime.UtcNow - self.StartTime.ToUniversalTime()).TotalSeconds;
        Scene scene = Scenes.Named(job.Scene);
        PinholeCamera camera = scene.Camera;
        Vector3D sun = ephemeris.SunPositionBodyFixed(scene.State.Time);

        long start = Stopwatch.GetTimestamp();
        IReadOnlyList<TileId> selected = [.. SphereRays.TilesOf(camera).Order()];
        double selection = Stopwatch.GetElapsedTime(start).TotalSeconds;

        start = Stopwatch.GetTimestamp();
        using LdemImage image = LdemImage.Open(LdemCatalog.Read(job.Label));
        IReadOnlyList<string> patterns = ThesisPatterns.Make(job.Patterns, Spread(selected, job.MaxTiles), image);
        double making = Stopwatch.GetElapsedTime(start).TotalSeconds;

        start = Stopwatch.GetTimestamp();
        using (StreamWriter writer = new(Path.Combine(job.Output, SceneName)))
        {
            ThesisScene.Write(writer, camera, sun, patterns);
        }

        ProgramRun povRay = new ChildProgram("povray", job.Output).Run(
        [
            $"+I{SceneName}", $"+O{ThesisFrameJob.ImageName}", "+FN8", "-D", Switch("+W", camera.Width), Switch("+H", camera.Height),
            Switch("+WT", Environment.ProcessorCount), .. ThesisScene.Options,
        ]);
        PovRayTimes times = PovRayTimes.Read(string.Join('\n', [.. povRay.Output.Select(line => line.Line), .. povRay.Errors]));
        self.Refresh();
        return new Dictionary<string, double>
        {
            ["tiles"] = patterns.Count,
            [ThesisFrameJob.SelectedTiles] = selected.Count,
            ["start_up_s"] = startUp,
            ["selection_s"] = selection,
            ["patterns_s"] = making,
            ["pov_ray_s"] = Stopwatch.GetElapsedTime(start).TotalSeconds,
            ["parse_s"] = times.ParseSeconds ?? 0.0,
            ["trace_s"] = times.TraceSeconds ?? 0.0,
            ["peak_memory_bytes"] = self.PeakWorkingSet64,
        };
    }

    /// <summary>At most so many of the tiles, evenly from all of them.</summary>
    private static IEnumerable<TileId> Spread(IReadOnlyList<TileId> tiles, int most)
    {
        int count = Math.Min(most, tiles.Count);
        return Enumerable.Range(0, count).Select(i => tiles[((2 * i) + 1) * tiles.Count / (2 * count)]);
    }

    private static string Switch(string name, int value) => string.Create(CultureInfo.InvariantCulture, $"{name}{value}");
}
