using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;

namespace Msisf.Benchmarks.Definitions;

/// <summary>
/// Moves a scene's camera on: on a circle about the Moon, towards what is up in the image, as fast as a spacecraft at that distance.
/// </summary>
internal static class Orbit
{
    /// <summary>Between two frames: half a pixel of the far scene, some 10 pixels from 100 km.</summary>
    private const double SecondsAFrame = 0.5;

    /// <summary>The camera of a frame; 0 is the scene's own.</summary>
    public static PinholeCamera CameraOf(Scene scene, int frame)
    {
        SpacecraftState state = scene.State;
        Vector3D position = state.PositionBodyFixed;
        double distance = position.Length;
        double meanMotion = Math.Sqrt(MoonConstants.GravitationalParameter / distance) / distance;
        Vector3D axis = Vector3D.Cross(position, state.MoonFromCamera * Vector3D.UnitZ);
        UnitQuaternion turn = UnitQuaternion.FromAxisAngle(axis, meanMotion * SecondsAFrame * frame);
        return scene.CameraAt(turn * position, turn * state.MoonFromCamera);
    }
}
