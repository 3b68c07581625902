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
    /// <summary>
    /// s: as long before and after a time the camera is looked at to know its turning, where no source says it: a power of 2, which moves
    /// a double of TDB by just as much.
    /// </summary>
    private const double HalfStep = 1.0 / 256.0;

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
    /// <returns>Null where the source has no velocity (0 stands for none), or the turning is not known.</returns>
    /// <exception cref="MsisfException">The time is outside the cover, or the data are damaged.</exception>
    public CameraMotion? StatedMotionAt(Instant time)
    {
        StateVector state = trajectory.StateJ2000(time.Tdb);
        if (state.Velocity == default)
        {
            return null;
        }

        TrajectoryPoint point = PointAt(time, state);
        Vector3D rateOfBody = ephemeris.BodyRateJ2000(point.Tdb);
        if (OfGround != Aberration.None)
        {
            return MotionOfPose(point, rateOfBody);
        }

        Vector3D velocity = point.BodyFromJ2000 * (state.Velocity - Vector3D.Cross(rateOfBody, state.Position));
        if (attitude.RateOf(point) is not { } stated)
        {
            return Neighbours(point, rateOfBody) is var (before, after, seconds)
                ? new CameraMotion(velocity, Turning(attitude.MoonFromCamera(before), attitude.MoonFromCamera(after), seconds))
                : null;
        }

        Vector3D ofBody = attitude.MoonFromCamera(point).Conjugate * (point.BodyFromJ2000 * rateOfBody);
        return new CameraMotion(velocity, stated.IsOverBody ? stated.AboutCamera : stated.AboutCamera - ofBody);
    }

    /// <summary>The motion of the pose that the ground's aberration moves.</summary>
    private CameraMotion? MotionOfPose(in TrajectoryPoint point, Vector3D rateOfBody)
    {
        if (Neighbours(point, rateOfBody) is not var (before, after, seconds))
        {
            return null;
        }

        (UnitQuaternion first, UnitQuaternion last) = (attitude.MoonFromCamera(before), attitude.MoonFromCamera(after));
        double lightRate = (GroundAberration.LightSeconds(after, last, GroundRadius)
            - GroundAberration.LightSeconds(before, first, GroundRadius)) / seconds;
        return new CameraMotion(
            GroundAberration.Velocity(point, attitude.MoonFromCamera(point), lightRate, ephemeris, GroundRadius),
            Turning(
                GroundAberration.Pose(before, first, OfGround, ephemeris, GroundRadius).MoonFromCamera,
                GroundAberration.Pose(after, last, OfGround, ephemeris, GroundRadius).MoonFromCamera,
                seconds));
    }

    /// <summary>
    /// The spacecraft a little before and after, on a straight line over a Moon that turns at a constant rate, so that no rounding of times
    /// and angles enters; null if the attitude is known at a single time only.
    /// </summary>
    private (TrajectoryPoint Before, TrajectoryPoint After, double Seconds)? Neighbours(in TrajectoryPoint point, Vector3D rateOfBody)
    {
        TrajectoryPoint middle = point;
        double before = attitude.Cover.Contains(middle.Time.After(-HalfStep).Tdb) ? -HalfStep : 0.0;
        double after = attitude.Cover.Contains(middle.Time.After(HalfStep).Tdb) ? HalfStep : 0.0;
        return before == after ? null : (At(before), At(after), after - before);

        TrajectoryPoint At(double seconds)
        {
            Instant time = middle.Time.After(seconds);
            TdbTime tdb = time.Tdb;
            StateVector state = middle.StateJ2000;
            Vector3D velocity = OfGround == Aberration.LightTimeAndStellar && trajectory.Cover.Contains(tdb)
                ? trajectory.StateJ2000(tdb).Velocity // its change turns the camera by 5e-9 rad/s
                : state.Velocity;
            RotationMatrix axes = middle.BodyFromJ2000;
            double angle = rateOfBody.Length * seconds;
            if (angle != 0.0)
            {
                UnitQuaternion turn = UnitQuaternion.FromAxisAngle(rateOfBody, angle);
                axes = new RotationMatrix(turn * axes.Row0, turn * axes.Row1, turn * axes.Row2);
            }

            return new(time, tdb, new StateVector(state.Position + (seconds * state.Velocity), velocity), axes);
        }
    }

    /// <summary>rad/s over the Moon, about the camera's axes.</summary>
    private static Vector3D Turning(UnitQuaternion before, UnitQuaternion after, double seconds) =>
        CameraMotion.Between((default, before), (default, after), seconds).AngularVelocityCamera;

    private TrajectoryPoint PointAt(Instant time, StateVector state)
    {
        TdbTime tdb = time.Tdb;
        return new(time, tdb, state, ephemeris.BodyFromJ2000(tdb));
    }

    /// <summary>What a sky that fits the drawn ground needs to know; null where finite light does nothing to the ground.</summary>
    public SkyObserver? Observer => OfGround == Aberration.None
        ? null
        : new SkyObserver(OfGround, time => trajectory.StateJ2000(time.Tdb).Velocity);

    /// <summary>The state of a frame.</summary>
    /// <exception cref="MsisfException">The time is outside the cover, which the message names, or the data are damaged.</exception>
    public SpacecraftState StateAt(Instant time)
    {
        CameraState camera = At(time);
        return new SpacecraftState(time, camera.PositionBodyFixed, camera.MoonFromCamera);
    }
}
