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
/// <param name="ephemeris">How the Moon turns; makes moments of times.</param>
public sealed class SpacecraftPath(ITrajectory trajectory, IAttitudeSource attitude, IEphemeris ephemeris) : ICameraPath
{
    /// <summary>s: as long before and after a time the camera is looked at to know its turning, where no source says it.</summary>
    private const double HalfStep = 0.005;

    /// <summary>What the finite speed of light does to the ground that is seen.</summary>
    public Aberration OfGround { get; init; }

    /// <summary>m: radius of the sphere that the ground is taken for.</summary>
    public double GroundRadius { get; init; } = MoonConstants.ReferenceRadius;

    /// <inheritdoc/>
    public TdbCover Cover { get; } = trajectory.Cover.Intersect(attitude.Cover);

    /// <inheritdoc/>
    public CameraState At(Instant time)
    {
        TrajectoryPoint point = PointAt(time, trajectory.StateJ2000(time.Tdb));
        (Vector3D position, UnitQuaternion moonFromCamera) = GroundAberration.Pose(
            point, attitude.MoonFromCamera(point), OfGround, ephemeris, GroundRadius);
        return new CameraState(position, moonFromCamera);
    }

    /// <summary>How the camera moves, by the velocity that its trajectory has and the rate that its attitude has.</summary>
    /// <returns>
    /// Null where the source has no velocity (0 stands for none), the turning is not known, or the ground's aberration moves the pose.
    /// </returns>
    /// <exception cref="MsisfException">The time is outside the cover, or the data are damaged.</exception>
    public CameraMotion? StatedMotionAt(Instant time)
    {
        StateVector state = trajectory.StateJ2000(time.Tdb);
        if (OfGround != Aberration.None || state.Velocity == default)
        {
            return null;
        }

        TrajectoryPoint point = PointAt(time, state);
        Vector3D ofBody = TurningMoon.RateBodyFixed(time.Tdb, ephemeris);
        Vector3D velocity = (point.BodyFromJ2000 * state.Velocity) - Vector3D.Cross(ofBody, point.PositionBodyFixed);
        if (attitude.RateOf(point) is not { } stated)
        {
            return Turning(time, state) is { } turning ? new CameraMotion(velocity, turning) : null;
        }

        return new CameraMotion(
            velocity,
            stated.IsOverBody ? stated.AboutCamera : stated.AboutCamera - (attitude.MoonFromCamera(point).Conjugate * ofBody));
    }

    /// <summary>
    /// rad/s over the Moon, about the camera's axes, from its attitudes on a straight line; null if they are known at a single time only.
    /// </summary>
    private Vector3D? Turning(Instant time, StateVector state)
    {
        double before = attitude.Cover.Contains(time.After(-HalfStep).Tdb) ? -HalfStep : 0.0;
        double after = attitude.Cover.Contains(time.After(HalfStep).Tdb) ? HalfStep : 0.0;
        return before == after
            ? null
            : CameraMotion.Between((default, At(before)), (default, At(after)), after - before).AngularVelocityCamera;

        UnitQuaternion At(double seconds) => attitude.MoonFromCamera(PointAt(
            time.After(seconds), state with { Position = state.Position + (seconds * state.Velocity) }));
    }

    private TrajectoryPoint PointAt(Instant time, StateVector state)
    {
        TdbTime tdb = time.Tdb;
        return new(time, tdb, state, ephemeris.BodyFromJ2000(tdb));
    }

    /// <summary>The state of a frame.</summary>
    /// <exception cref="MsisfException">The time is outside the cover, which the message names, or the data are damaged.</exception>
    public SpacecraftState StateAt(Instant time)
    {
        CameraState camera = At(time);
        return new SpacecraftState(time, camera.PositionBodyFixed, camera.MoonFromCamera);
    }
}
