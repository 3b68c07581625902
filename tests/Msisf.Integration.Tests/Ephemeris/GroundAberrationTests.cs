using Msisf.Adapters.Ephemeris;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.Core.Scene;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>
/// Which point of the Moon a camera sees along its line of sight, against a search without the class: the point of the turning Moon whose
/// light, sent at t - d/c, comes in along the line of sight, turned by the camera's motion through the solar system (special relativity).
/// </summary>
public sealed class GroundAberrationTests
{
    private const double Radius = 1_737_400.0;
    private const double C = 299_792_458.0;

    [RequiresTheory(Part.CSpice)]
    [InlineData(100e3, Aberration.LightTimeAndStellar)]
    [InlineData(60_000e3, Aberration.LightTimeAndStellar)]
    [InlineData(400_000e3, Aberration.LightTimeAndStellar)]
    [InlineData(100e3, Aberration.LightTime)]
    [InlineData(400_000e3, Aberration.LightTime)]
    [InlineData(400_000e3, Aberration.None)]
    public void Pose_PointSeenOnTheLineOfSight_IsThatOfTheLight(double height, Aberration aberration)
    {
        using OpenedEphemeris opened = Engines.BuiltIn();
        Straight trajectory = new(height);
        SpacecraftPath path = new(trajectory, new Slanting(), opened.Engine) { OfGround = aberration };
        CameraState camera = path.At(opened.Engine.TimeScale.InstantOf(3.02e8));
        Vector3D expected = Seen(opened.Engine, trajectory, aberration);

        Vector3D forward = camera.MoonFromCamera * -Vector3D.UnitX;
        double along = -Vector3D.Dot(camera.PositionBodyFixed, forward);
        double miss = (camera.PositionBodyFixed + (along * forward)).Length;
        Vector3D actual = camera.PositionBodyFixed + ((along - Math.Sqrt((Radius * Radius) - (miss * miss))) * forward);

        // First order in v/c: 1e-8 of the distance; and the way that the rounding of 1.5e11 m allows.
        Assert.InRange((actual - expected).Length, 0.0, 1e-3 + (1.1e-8 * height));
    }

    /// <summary>By iteration in the barycentre's frame.</summary>
    private static Vector3D Seen(IEphemeris engine, Straight trajectory, Aberration aberration)
    {
        const double Time = 3.02e8;
        StateVector state = trajectory.StateJ2000(Time);
        StateVector center = engine.StateOf(0, Time);
        RotationMatrix moonMe = engine.BodyFromJ2000(Time);
        TrajectoryPoint point = new(engine.TimeScale.InstantOf(Time), Time, state, moonMe);
        Vector3D apparent = moonMe.Transposed * (new Slanting().MoonFromCamera(point) * -Vector3D.UnitX);
        Vector3D velocity = (state.Velocity - center.Velocity) / C;
        Vector3D direction = aberration == Aberration.LightTimeAndStellar ? AtRest(apparent, velocity) : apparent;
        double distance = 0.0;
        Vector3D hit = default;
        for (int i = 0; i < 20; i++)
        {
            double sent = Time - (aberration == Aberration.None ? 0.0 : distance / C);
            Vector3D fromMoonThen = state.Position + (engine.StateOf(0, sent).Position - center.Position);
            double along = -Vector3D.Dot(fromMoonThen, direction);
            double miss = (fromMoonThen + (along * direction)).Length;
            distance = along - Math.Sqrt((Radius * Radius) - (miss * miss));
            hit = engine.BodyFromJ2000(sent) * (fromMoonThen + (distance * direction));
        }

        return hit;
    }

    /// <summary>Where light comes from, for somebody at rest, that a moving one sees come from a direction (Lorentz).</summary>
    private static Vector3D AtRest(Vector3D apparent, Vector3D velocityInC)
    {
        double gamma = 1.0 / Math.Sqrt(1.0 - velocityInC.LengthSquared);
        double along = Vector3D.Dot(apparent, velocityInC);
        return (((1.0 / gamma) * apparent) - ((1.0 - (gamma / (gamma + 1.0) * along)) * velocityInC)).Normalized();
    }

    private sealed class Straight(double height) : ITrajectory
    {
        public TdbCover Cover => TdbCover.Everything;

        public StateVector StateJ2000(TdbTime time) =>
            new(new Vector3D(0.6, -0.64, 0.48) * (Radius + height), new Vector3D(900.0, 1100.0, 400.0));
    }

    /// <summary>Somewhat off the nadir, so that the light's way is not the height.</summary>
    private sealed class Slanting : IAttitudeSource
    {
        public UnitQuaternion MoonFromCamera(in TrajectoryPoint point) => NadirPointing.MoonFromCamera(point.PositionBodyFixed)
            * UnitQuaternion.FromAxisAngle(Vector3D.UnitZ, 0.5 * Radius / point.PositionBodyFixed.Length);
    }
}
