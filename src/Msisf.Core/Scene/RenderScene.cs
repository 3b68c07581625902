using Msisf.Core.Camera;

namespace Msisf.Core.Scene;

/// <summary>Everything that is needed to render one image.</summary>
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

/// <summary>The map that colours the surface of a scene.</summary>
/// <param name="ImageName">
/// File name of the map's image in the folder of the patterns: linear grey, north up, the whole Moon and a row more over each pole.
/// </param>
/// <param name="WestDegrees">East longitude of the image's left edge.</param>
/// <param name="Rows">Rows of the map in the image, between one row over each pole.</param>
/// <param name="Diffuse">Radiance factor of white with the Sun in the zenith.</param>
public sealed record SceneAlbedo(string ImageName, double WestDegrees, int Rows, double Diffuse);

/// <summary>The one light of a scene.</summary>
/// <param name="PositionBodyFixed">m, body-fixed.</param>
/// <param name="IsSun">The Sun; otherwise a lamp at the camera (<c>--ignore-sun</c>), which has no disc.</param>
public readonly record struct SceneLight(Vector3D PositionBodyFixed, bool IsSun)
{
    /// <summary>Radius of the light's disc, m, if it is one.</summary>
    public double Radius { get; init; } = Ephemeris.AstronomicalConstants.SunRadius;

    /// <summary>The light of a row: at the camera's place of that time, or where the Sun is then.</summary>
    /// <param name="camera">The frame's camera; one state has the frame's light.</param>
    /// <param name="y">Rendering coordinate.</param>
    public SceneLight At(ICamera camera, double y) => camera.Bands.Count == 1 ? this : Of(camera.BandAt(y).Camera.State);

    /// <summary>The light of a camera's state.</summary>
    internal SceneLight Of(CameraState state) =>
        this with { PositionBodyFixed = IsSun ? state.SunPositionBodyFixed ?? PositionBodyFixed : state.PositionBodyFixed };
}
