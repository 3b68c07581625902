using Msisf.Core.Camera;
using Msisf.Core.Numerics;

namespace Msisf.Core.Scene;

/// <summary>The one light of a scene.</summary>
/// <param name="PositionMoonMe">m, MOON_ME.</param>
/// <param name="IsSun">The Sun; otherwise a lamp at the camera (<c>--ignore-sun</c>), which has no disc.</param>
public readonly record struct SceneLight(Vector3D PositionMoonMe, bool IsSun)
{
    /// <summary>The light of a row: at the camera's place of that time, or where the Sun is then.</summary>
    /// <param name="camera">The frame's camera; one state has the frame's light.</param>
    /// <param name="y">Rendering coordinate.</param>
    public SceneLight At(ICamera camera, double y) => camera.Bands.Count == 1 ? this : Of(camera.BandAt(y).Camera.State);

    /// <summary>The light of a camera's state.</summary>
    internal SceneLight Of(CameraState state) =>
        this with { PositionMoonMe = IsSun ? state.SunPositionMoonMe ?? PositionMoonMe : state.PositionMoonMe };
}
