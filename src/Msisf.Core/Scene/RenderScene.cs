using Msisf.Core.Camera;

namespace Msisf.Core.Scene;

/// <summary>Everything that is needed to render one image.</summary>
/// <param name="Camera">The camera.</param>
/// <param name="Light">The Sun, or the lamp at the camera.</param>
/// <param name="PatternFolder">Name of the folder of the surface's meshes in the pattern repository.</param>
/// <param name="Patterns">File names of the meshes that the image needs, in the order in which they are included.</param>
/// <param name="Albedo">Map of the surface's reflectance; null for the thesis's even grey.</param>
public sealed record RenderScene(
    FrameCamera Camera, SceneLight Light, string PatternFolder, IReadOnlyList<string> Patterns, SceneAlbedo? Albedo = null)
{
    /// <summary>The scene's axes; tiles always lie in kilometres from the Moon's centre.</summary>
    public SceneAxes Axes { get; init; } = SceneAxes.MoonKilometres;
}
