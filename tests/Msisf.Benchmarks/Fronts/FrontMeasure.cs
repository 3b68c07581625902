using Msisf.Adapters.Raster.Heights;
using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Programs;
using Msisf.Benchmarks.Thesis;
using Msisf.Core.Ephemeris;
using Msisf.Core.Lod;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.TestSupport.Images;

namespace Msisf.Benchmarks.Fronts;

/// <summary>Measures time and error of all ways to make a scene's image.</summary>
internal sealed class FrontMeasure
{
    /// <summary>s: an image that takes longer is made once, and what making its patterns took is taken off.</summary>
    private const double MaxRepeatedSeconds = 6.0;

    /// <summary>s: an image that takes no longer is made twice as often, because other programs disturb it more.</summary>
    private const double ShortSeconds = 3.0;

    /// <summary>s: POV-Ray parses a scene once more to trace single points in it.</summary>
    private const double MaxParseForHits = 4.0;

    private readonly Workbench _bench;
    private readonly IEphemeris _ephemeris;
    private readonly int _images;
    private readonly ImageMaker _maker;
    private readonly TextWriter _log;

    /// <summary>Prepares.</summary>
    /// <param name="bench">Where things are.</param>
    /// <param name="ephemeris">For the Sun.</param>
    /// <param name="images">How often to make an image again that takes seconds.</param>
    /// <param name="log">Is told of each way.</param>
    public FrontMeasure(Workbench bench, IEphemeris ephemeris, int images, TextWriter log)
    {
        _log = log;
        _bench = bench;
        _ephemeris = ephemeris;
        _images = images;
        _maker = new ImageMaker(bench);
    }

    /// <summary>Measures a scene.</summary>
    public SceneFront Measure(Scene scene)
    {
        using LdemImage image = LdemImage.Open(_bench.Model(scene.Model));
        using ModelLevels model = ModelLevels.Open(image, cacheFolder: null);
        SceneLight sun = new(_ephemeris.SunPositionBodyFixed(scene.State.Time), IsSun: true);
        ImageTruth? truth = scene.HasTruth ? ImageTruth.Draw(scene.Camera, sun, image) : null;
        HitPixels pixels = new(scene.Camera, image);
        List<SettingResult> results = [];
        List<(Setting, string)> failures = [];
        foreach (Setting setting in scene.Settings)
        {
            try
            {
                SettingResult result = Measure(scene, setting, truth, pixels, model.Levels);
                _log.WriteLine(
                    FormattableString.Invariant(
                        $"          {setting.Name}: {result.Seconds.Median:F2} s{(result.IsScaled ? ", scaled" : string.Empty)}"));
                results.Add(result);
            }
            catch (BenchmarkException failure)
            {
                // The report is for all: it shall not hold the folders of this machine.
                string message = failure.Message.Replace(_bench.Root + Path.DirectorySeparatorChar, string.Empty, StringComparison.Ordinal);
                _log.WriteLine($"          {setting.Name}: failed: {message}");
                failures.Add((setting, message));
            }
            finally
            {
                Workbench.Delete(_bench.PatternsOf(scene, setting)); // gigabytes, all settings together
            }
        }

        return new SceneFront(scene, results, failures);
    }

    private SettingResult Measure(Scene scene, Setting setting, ImageTruth? truth, HitPixels pixels, LodLevels levels)
    {
        Workbench.Delete(_bench.PatternsOf(scene, setting));
        string output = _bench.NewOutputFolder();
        ProgramRun first = _maker.Make(scene, setting, output);
        List<ProgramRun> further = [];
        int wanted = !setting.IsRepeated || first.Seconds > MaxRepeatedSeconds ? 0 : first.Seconds > ShortSeconds ? _images : 2 * _images;
        for (int image = 0; image < wanted; image++)
        {
            output = _bench.NewOutputFolder();
            further.Add(_maker.Make(scene, setting, output));
        }

        RunTiming firstTiming = RunTiming.Of(first);
        ProgramRun last = further.LastOrDefault(first);
        RunTiming timing = RunTiming.Of(last);
        int measuredTiles = (int)(timing.CountOf("tiles") ?? 0.0);
        int tiles = (int)(timing.CountOf(ThesisFrameJob.SelectedTiles) ?? measuredTiles);
        bool isWhole = tiles == measuredTiles;
        double missing = isWhole ? 0.0 : ((double)tiles / measuredTiles) - 1.0;
        double[] seconds = further.Count == 0
            ? [first.Seconds - firstTiming.SecondsOf("patterns")]
            : [.. further.Select(run => run.Seconds)];
        return new SettingResult
        {
            Setting = setting,
            Seconds = new Samples(seconds.Select(whole => whole + (missing * timing.SecondsOf("parse")))),
            Timing = timing,
            FirstSeconds = first.Seconds,
            PovRayPeakBytes = Math.Max(first.ChildrenPeakBytes, last.ChildrenPeakBytes),
            Patterns = setting.Kind == SettingKind.Native ? null : PatternFolder.Of(_bench.PatternsOf(scene, setting)),
            Tiles = tiles,
            MeasuredTiles = measuredTiles,
            Error = truth is not null && isWhole ? ImageError.Of(truth, Single(output, "*.png")) : null,
            Hits = isWhole && setting.HasOwnSurface && timing.SecondsOf("parse") < MaxParseForHits
                ? Hits(scene, setting, output, pixels, levels)
                : null,
        };
    }

    private HitDistance Hits(Scene scene, Setting setting, string output, HitPixels pixels, LodLevels levels)
    {
        IReadOnlyList<Vector3D?> points = setting.Kind == SettingKind.Native
            ? pixels.ByNative(
                levels.Level(
                    setting.IsFull
                        ? 0
                        : new DetailRule(levels, DetailRule.DefaultError).LevelOfImage(
                            scene.Camera.Footprint, setting.SubsamplesPerAxis)))
            : PovRayHits.Trace(Single(output, "*.pov"), _bench.PatternsOf(scene, setting), pixels.Rays, output);
        return HitDistance.Of(pixels.Truth, points);
    }

    private static string Single(string folder, string pattern) => Directory.GetFiles(folder, pattern) is [string file]
        ? file
        : throw new BenchmarkException($"{folder} has not exactly one {pattern}.");
}
