using Msisf.Core.Camera;
using Msisf.Core.Tiles;

namespace Msisf.Core.Scene;

/// <summary>Everything that is needed to render one image.</summary>
/// <param name="Camera">The camera.</param>
/// <param name="Light">The Sun, or the lamp at the camera.</param>
/// <param name="PixelsPerDegree">Resolution of the model, px/deg.</param>
/// <param name="Parts">The pieces of surface that the image needs, in the order in which they are included.</param>
/// <param name="Albedo">Map of the surface's reflectance; null for the thesis's even grey.</param>
public sealed record RenderScene(
    PinholeCamera Camera, SceneLight Light, int PixelsPerDegree, IReadOnlyList<SurfacePart> Parts, SceneAlbedo? Albedo = null);
