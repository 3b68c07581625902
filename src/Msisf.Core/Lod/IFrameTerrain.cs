using Msisf.Core.Camera;
using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>Chooses the terrain that a frame is drawn from; the choice follows from the frame alone. Safe for several threads.</summary>
public interface IFrameTerrain
{
    /// <summary>The terrain of a frame; mostly the same object for frames that need the same.</summary>
    /// <param name="camera">The frame's camera.</param>
    /// <param name="subsamplesPerAxis">Samples along a pixel's edge.</param>
    ITerrain For(ICamera camera, int subsamplesPerAxis);
}
