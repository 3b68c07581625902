using Msisf.Core.Camera;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>Every frame shows the models and as much invented detail as its pixels need.</summary>
/// <param name="terrain">The models with their detail.</param>
public sealed class RefinedDetail(RefinedTerrain terrain) : IFrameTerrain
{
    /// <inheritdoc/>
    public ITerrain For(ICamera camera, int subsamplesPerAxis) => terrain.For(camera, subsamplesPerAxis);
}
