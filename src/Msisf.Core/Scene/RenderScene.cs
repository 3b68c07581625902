using Msisf.Core.Camera;
using Msisf.Core.Tiles;

namespace Msisf.Core.Scene;

/// <summary>All that one image needs, nothing else.</summary>
/// <param name="Camera">Where from and how.</param>
/// <param name="Light">The Sun, or the lamp at the camera.</param>
/// <param name="PixelsPerDegree">Resolution of the model.</param>
/// <param name="Parts">The pieces of surface that the image needs, in the order in which they are included.</param>
public sealed record RenderScene(PinholeCamera Camera, SceneLight Light, int PixelsPerDegree, IReadOnlyList<SurfacePart> Parts);
