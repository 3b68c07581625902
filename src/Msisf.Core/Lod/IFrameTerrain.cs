using Msisf.Core.Camera;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>Chooses the terrain that a frame is drawn from; the choice follows from the frame alone. Safe for several threads.</summary>
public interface IFrameTerrain
{
    /// <summary>The terrain of a frame; mostly the same object for frames that need the same.</summary>
    /// <param name="subsamplesPerAxis">Samples along a pixel's edge.</param>
    ITerrain For(ICamera camera, int subsamplesPerAxis);
}

/// <summary>Every frame shows the models themselves.</summary>
/// <param name="terrain">The model, or several.</param>
public sealed class FullDetail(ITerrain terrain) : IFrameTerrain
{
    /// <inheritdoc/>
    public ITerrain For(ICamera camera, int subsamplesPerAxis) => terrain;
}

/// <summary>Every frame shows the coarsest level of one model that is fine enough for all of it.</summary>
/// <param name="errorPixels">px: how far a coarser level may move what is seen.</param>
public sealed class ModelDetail(TerrainLevels levels, double errorPixels) : IFrameTerrain
{
    private readonly DetailRule _rule = new(levels, errorPixels);

    /// <inheritdoc/>
    public ITerrain For(ICamera camera, int subsamplesPerAxis) =>
        levels.Grid(camera.Bands.Min(band => _rule.LevelOfImage(band.Camera.Footprint, subsamplesPerAxis)));
}

/// <summary>Every frame shows the models and as much invented detail as its pixels need.</summary>
public sealed class RefinedDetail(RefinedTerrain terrain) : IFrameTerrain
{
    /// <inheritdoc/>
    public ITerrain For(ICamera camera, int subsamplesPerAxis) => terrain.For(camera, subsamplesPerAxis);
}
