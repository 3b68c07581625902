using Msisf.Adapters.Ephemeris;
using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>
/// What missions.md says of a turn by the aberration of the image's middle: how far it is off elsewhere in the image. Directions come from
/// special relativity.
/// </summary>
public sealed class AberrationBoundTests
{
    private const double C = 299_792_458.0;

    /// <summary>m/s: the fastest of circles about the Moon, at the ground.</summary>
    private const double LowOrbit = 1_680.0;

    private static readonly double Arcsecond = double.DegreesToRadians(1.0 / 3600.0);

    /// <summary>The Moon's speed over 150 years: 31.4 km/s at most, which are 21.6 arcseconds; 22.7 with an orbit's.</summary>
    [Fact]
    public void Speed_OfTheMoonAroundTheSun_IsThatOfThePage()
    {
        using OpenedEphemeris opened = Engines.BuiltIn();
        double most = 0.0;
        for (double days = -36_000.0; days < 18_500.0; days += 1.3)
        {
            most = Math.Max(most, opened.Engine.StateOf(0, 86_400.0 * days).Velocity.Length);
        }

        Assert.Equal(31.4, most / 1000.0, 0.05);
        Assert.InRange(most / C / Arcsecond, 21.5, 21.6);
        Assert.InRange((most + LowOrbit) / C / Arcsecond, 22.6, 22.76);
    }

    /// <summary>The camera looks along its motion, across it, and between; directions lie all around its line of sight.</summary>
    [Theory]
    [InlineData(0.0, 0.0)]
    [InlineData(0.0, LowOrbit)]
    [InlineData(30.0, LowOrbit)] // half of the greatest angle from the middle: the worst case
    [InlineData(45.0, LowOrbit)]
    [InlineData(90.0, 0.0)]
    [InlineData(180.0, LowOrbit)]
    public void Pose_DirectionOffTheMiddle_IsOffAsThePageSays(double lookDegrees, double speed)
    {
        using OpenedEphemeris opened = Engines.BuiltIn();
        TdbTime time = 3.02e8;
        Vector3D withMoon = -opened.Engine.StateOf(0, time).Velocity;
        Vector3D motion = withMoon.Normalized();
        Vector3D across = Vector3D.Cross(motion, Vector3D.UnitZ).Normalized();
        Vector3D inC = (withMoon + (speed * motion)) / C;
        double look = double.DegreesToRadians(lookDegrees);
        Vector3D forward = (Math.Cos(look) * motion) + (Math.Sin(look) * across);
        StateVector state = new(-3e6 * forward, speed * motion);
        RotationMatrix moonMe = opened.Engine.BodyFromJ2000(time);
        TrajectoryPoint point = new(opened.Engine.TimeScale.InstantOf(time), time, state, moonMe);
        UnitQuaternion j2000FromCamera = Towards(forward);
        UnitQuaternion moonFromCamera = UnitQuaternion.FromMatrix(moonMe) * j2000FromCamera;

        (_, UnitQuaternion pose) = GroundAberration.Pose(
            point, moonFromCamera, Aberration.LightTimeAndStellar, opened.Engine, 1_737_400.0);

        RotationMatrix moonThen = opened.Engine.BodyFromJ2000(
            time + -GroundAberration.LightSeconds(point, moonFromCamera, 1_737_400.0));
        double most = 0.0;
        for (int degrees = 0; degrees <= 60; degrees += 5)
        {
            double angle = double.DegreesToRadians(degrees);
            for (int turn = 0; turn < 360; turn += 30)
            {
                (double sine, double cosine) = Math.SinCos(double.DegreesToRadians(turn));
                Vector3D inCamera = new(-Math.Cos(angle), Math.Sin(angle) * cosine, Math.Sin(angle) * sine);
                double off = Angle(moonThen.Transposed * (pose * inCamera), AtRest(j2000FromCamera * inCamera, inC));
                double bound = inC.Length * FactorOf(angle, lookDegrees);
                Assert.InRange(off, 0.0, (1.001 * bound) + 2e-8); // rad: second order in v/c
                most = Math.Max(most, off);
            }
        }

        if (lookDegrees != 45.0)
        {
            double bound = inC.Length * FactorOf(double.DegreesToRadians(60.0), lookDegrees);
            Assert.InRange(most, 0.99 * bound, 1.001 * bound); // it is reached
        }
    }

    /// <summary>The page's factors: along the motion, across it, and anywhere.</summary>
    private static double FactorOf(double angle, double lookDegrees) => lookDegrees switch
    {
        0.0 or 180.0 => Math.Sin(angle),
        90.0 => 1.0 - Math.Cos(angle),
        _ => 2.0 * Math.Sin(0.5 * angle),
    };

    /// <summary>A camera, which looks along -x, turned to look along a direction.</summary>
    private static UnitQuaternion Towards(Vector3D forward)
    {
        Vector3D y = Vector3D.Cross(Vector3D.UnitZ, -forward).Normalized();
        Vector3D z = Vector3D.Cross(-forward, y);
        return UnitQuaternion.FromMatrix(new RotationMatrix(-forward, y, z).Transposed);
    }

    /// <summary>Small angles too.</summary>
    private static double Angle(Vector3D a, Vector3D b) => Math.Atan2(Vector3D.Cross(a, b).Length, Vector3D.Dot(a, b));

    /// <summary>Where light comes from, for somebody at rest, that a moving one sees come from a direction (Lorentz).</summary>
    private static Vector3D AtRest(Vector3D apparent, Vector3D velocityInC)
    {
        double gamma = 1.0 / Math.Sqrt(1.0 - velocityInC.LengthSquared);
        double along = Vector3D.Dot(apparent, velocityInC);
        return (((1.0 / gamma) * apparent) - ((1.0 - (gamma / (gamma + 1.0) * along)) * velocityInC)).Normalized();
    }
}
