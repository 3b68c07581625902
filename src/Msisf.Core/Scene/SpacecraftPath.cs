using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.Core.Scene;

/// <summary>The camera of a spacecraft that flies along a trajectory. As thread-safe as its ephemeris.</summary>
/// <param name="trajectory">Where the spacecraft is.</param>
/// <param name="attitude">How its camera points.</param>
/// <param name="ephemeris">How the Moon turns; counts the times.</param>
public sealed class SpacecraftPath(ITrajectory trajectory, IAttitudeSource attitude, IEphemeris ephemeris) : ICameraPath
{
    /// <summary>What the finite speed of light does to the ground that is seen.</summary>
    public Aberration OfGround { get; init; }

    /// <summary>m: radius of the sphere that the ground is taken for.</summary>
    public double GroundRadius { get; init; } = MoonConstants.ReferenceRadius;

    /// <inheritdoc/>
    public TdbCover Cover { get; } = trajectory.Cover.Intersect(attitude.Cover);

    /// <inheritdoc/>
    public CameraState At(double tdbSeconds)
    {
        TrajectoryPoint point = new(
            tdbSeconds, ephemeris.TimeScale.ToUtc(tdbSeconds), trajectory.StateJ2000(tdbSeconds), ephemeris.BodyFromJ2000(tdbSeconds));
        (Vector3D position, UnitQuaternion moonFromCamera) = GroundAberration.Pose(
            point, attitude.MoonFromCamera(point), OfGround, ephemeris, GroundRadius);
        return new CameraState(position, moonFromCamera);
    }

    /// <summary>The state of a frame.</summary>
    /// <param name="time">UTC.</param>
    /// <exception cref="MsisfException">The time is outside the cover, which the message names, or the data are damaged.</exception>
    public SpacecraftState At(ModifiedJulianDate time)
    {
        CameraState camera = At(ephemeris.TimeScale.FromUtc(time));
        return new SpacecraftState(time, camera.PositionBodyFixed, camera.MoonFromCamera);
    }
}
