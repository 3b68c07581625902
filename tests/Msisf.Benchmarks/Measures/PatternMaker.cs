using Msisf.Adapters.Terrain;
using Msisf.Adapters.Tiles;
using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Programs;
using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Benchmarks.Measures;

/// <summary>Makes the patterns of a scene, so that POV-Ray's way is measured with patterns in place.</summary>
internal static class PatternMaker
{
    /// <summary>Makes what is not there; also the model's summary, from which the tiles are chosen.</summary>
    /// <returns>How many patterns the scene takes.</returns>
    public static int Make(Scene scene, Workbench bench, IEphemeris ephemeris)
    {
        LdemSet model = bench.Model(scene.PixelsPerDegree);
        using LdemImage image = LdemImage.Open(model);
        (ElevationSummary summary, _) = ElevationSummaryFile.LoadOrBuild(model.FileBeside(".summary"), SummarySource.Of(model), image);
        TileSelection selection = Dspsa.Select(scene.Camera, ephemeris.SunPositionMoonMe(scene.State.Time), image, summary);
        TileId[] tiles = [.. selection.Kept.Select(choice => choice.Tile)];
        new PatternRepository(bench.Patterns).EnsurePatterns(
            tiles, image, new PatternOptions(0.0, PatternFormat.Mesh2), Environment.ProcessorCount);
        return tiles.Length;
    }
}
