using Msisf.Core.Camera;
using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>Every frame shows the models themselves.</summary>
/// <param name="terrain">The model, or several.</param>
public sealed class FullDetail(ITerrain terrain) : IFrameTerrain
{
    /// <inheritdoc/>
    public ITerrain For(ICamera camera, int subsamplesPerAxis) => terrain;
}
