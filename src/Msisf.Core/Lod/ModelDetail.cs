using Msisf.Core.Camera;
using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>Every frame shows the coarsest level of one model that is fine enough for all of it.</summary>
/// <param name="levels">The model and its levels.</param>
/// <param name="errorPixels">px: how far a coarser level may move what is seen.</param>
public sealed class ModelDetail(TerrainLevels levels, double errorPixels) : IFrameTerrain
{
    private readonly DetailRule _rule = new(levels, errorPixels);

    /// <inheritdoc/>
    public ITerrain For(ICamera camera, int subsamplesPerAxis) =>
        levels.Grid(camera.Bands.Min(band => _rule.LevelOfImage(band.Camera.Footprint, subsamplesPerAxis)));
}
