using Msisf.Adapters.Raster.Heights;
using Msisf.Benchmarks.Definitions;
using Msisf.Core.Lod;
using Msisf.Core.Terrain;

namespace Msisf.Benchmarks.Measures;

/// <summary>A scene's model, opened without a pyramid file.</summary>
internal sealed class DrawnModel : IDisposable
{
    private readonly IDisposable _opened;
    private readonly TerrainLevels _levels;

    private DrawnModel(IDisposable opened, TerrainLevels levels) => (_opened, _levels) = (opened, levels);

    public static DrawnModel Open(string label)
    {
        if (LdemCatalog.TryReadMap(label) is { } map)
        {
            LdemMapImage polar = LdemMapImage.Open(LdemSet.OfMap(map));
            return new DrawnModel(polar, MapLevels.Open(polar));
        }

        LdemImage image = LdemImage.Open(LdemCatalog.Read(label));
        return new DrawnModel(image, LodLevels.Open(image));
    }

    /// <summary>The level that a scene is drawn with.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="subsamplesPerAxis">Samples along a pixel's edge.</param>
    public ITerrainGrid LevelFor(Scene scene, int subsamplesPerAxis = 1) => _levels.Grid(scene.IsExact
        ? 0
        : new DetailRule(_levels, DetailRule.DefaultError).LevelOfImage(scene.Camera.Footprint, subsamplesPerAxis));

    public void Dispose() => _opened.Dispose();
}
