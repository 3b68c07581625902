using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Core.Scene;

/// <summary>
/// What the finite speed of light does to the ground that a camera sees, as a change of the camera: it sees the Moon where and as it was
/// when the light left it, and, moving itself, turned towards its motion.
/// </summary>
/// <remarks>
/// The light time is that from the ground on the line of sight, for the whole image; without ground there, from the nearest point of the
/// sphere. The stellar aberration is that of the line of sight, too: at an angle a from it the image is off by up to v / c times
/// 2 sin(a / 2), where v is the camera's speed through the solar system: v / c is 21.6 arcseconds with the Moon, 22.7 in low orbit. It is
/// sin a where the camera looks along its motion, and 1 - cos a where it looks across.
/// </remarks>
public static class GroundAberration
{
    private const double MetresPerKilometre = 1000.0;

    /// <summary>The pose of a camera that sees without light time what the camera at a point of its path really sees.</summary>
    /// <param name="point">The camera's place.</param>
    /// <param name="moonFromCamera">How it points.</param>
    /// <param name="aberration">What is taken in.</param>
    /// <param name="ephemeris">Where the solar system's barycentre is, and how the Moon turns.</param>
    /// <param name="radius">Radius of the sphere that stands for the ground, m.</param>
    /// <returns>Position (m, MOON_ME) and orientation.</returns>
    public static (Vector3D PositionBodyFixed, UnitQuaternion MoonFromCamera) Pose(
        in TrajectoryPoint point, UnitQuaternion moonFromCamera, Aberration aberration, IEphemeris ephemeris, double radius)
    {
        if (aberration == Aberration.None)
        {
            return (point.PositionBodyFixed, moonFromCamera);
        }

        double seconds = LightSeconds(point, moonFromCamera, radius);
        RotationMatrix moonThen = ephemeris.BodyFromJ2000(point.Tdb + -seconds);
        UnitQuaternion j2000FromCamera = UnitQuaternion.FromMatrix(point.BodyFromJ2000.Transposed) * moonFromCamera;
        if (aberration == Aberration.LightTimeAndStellar)
        {
            // The sine of the angle is that of CSPICE's STELAB; the camera looks along a direction in which light seems to come.
            Vector3D forward = j2000FromCamera * -Vector3D.UnitX;
            Vector3D inC = (point.StateJ2000.Velocity - BarycenterVelocity(point.Tdb, ephemeris))
                / (MetresPerKilometre * LightSpeed.KilometresPerSecond);
            j2000FromCamera = Turn(forward, inC) * j2000FromCamera;
        }

        return (
            moonThen * FromMoonThen(point, seconds, ephemeris),
            UnitQuaternion.FromMatrix(moonThen) * j2000FromCamera);
    }

    /// <summary>How fast the position of that pose changes: m/s, MOON_ME.</summary>
    /// <param name="lightRate">By how many seconds the light time grows in one.</param>
    /// <inheritdoc cref="Pose"/>
    public static Vector3D Velocity(
        in TrajectoryPoint point, UnitQuaternion moonFromCamera, double lightRate, IEphemeris ephemeris, double radius)
    {
        double seconds = LightSeconds(point, moonFromCamera, radius);
        TdbTime sent = point.Tdb + -seconds;
        Vector3D overMoonThen = BarycenterVelocity(sent, ephemeris)
            - Vector3D.Cross(ephemeris.BodyRateJ2000(sent), FromMoonThen(point, seconds, ephemeris));
        return ephemeris.BodyFromJ2000(sent)
            * (point.StateJ2000.Velocity - BarycenterVelocity(point.Tdb, ephemeris) + ((1.0 - lightRate) * overMoonThen));
    }

    /// <summary>The turn from the real orientation of a camera to that with which its ground is drawn.</summary>
    /// <param name="forward">Where the real camera looks, length 1.</param>
    /// <param name="velocityInC">Velocity of the camera through the solar system, over that of light, along the same axes.</param>
    internal static UnitQuaternion Turn(Vector3D forward, Vector3D velocityInC)
    {
        Vector3D axis = Vector3D.Cross(forward, velocityInC);
        double sine = axis.Length;
        return sine == 0.0
            ? UnitQuaternion.Identity
            : UnitQuaternion.FromAxisAngle(axis, -Math.Atan2(sine, Math.Sqrt(1.0 - (sine * sine))));
    }

    /// <summary>s: how long light from the ground has been on its way to a camera in its drawn pose.</summary>
    /// <param name="radius">Radius of the sphere that stands for the ground, m.</param>
    /// <remarks>The pose is that of the ground as it was, 1e-4 of the distance off: of the time it is as little.</remarks>
    internal static double LightSeconds(in CameraState drawn, double radius) => LightSpeed.TimeOver(
        Distance(drawn.PositionBodyFixed, drawn.MoonFromCamera * -Vector3D.UnitX, radius) / MetresPerKilometre);

    /// <summary>s: how long the light is on its way.</summary>
    /// <inheritdoc cref="Pose"/>
    public static double LightSeconds(in TrajectoryPoint point, UnitQuaternion moonFromCamera, double radius) => LightSpeed.TimeOver(
        Distance(point.PositionBodyFixed, moonFromCamera * -Vector3D.UnitX, radius) / MetresPerKilometre);

    /// <summary>
    /// m, J2000: from the Moon's centre as it was some seconds before to the camera. The Moon's way is its velocity in the middle by the
    /// time, which is exact to 1e-10 m; a difference of positions would be one of 1.5e11 m.
    /// </summary>
    private static Vector3D FromMoonThen(in TrajectoryPoint point, double seconds, IEphemeris ephemeris) =>
        point.StateJ2000.Position - (seconds * BarycenterVelocity(point.Tdb + (-0.5 * seconds), ephemeris));

    /// <summary>m/s, J2000: of the solar system's barycentre as seen from the Moon.</summary>
    private static Vector3D BarycenterVelocity(TdbTime time, IEphemeris ephemeris) =>
        ephemeris.StateOf(SegmentTable.SolarSystemBarycenter, time).Velocity;

    /// <summary>m: along the line of sight to the sphere, or to the nearest point of the sphere.</summary>
    private static double Distance(Vector3D position, Vector3D forward, double radius)
    {
        double along = -Vector3D.Dot(position, forward);
        double miss = (position + (along * forward)).Length;
        return along > 0.0 && miss < radius
            ? along - Math.Sqrt((radius - miss) * (radius + miss))
            : Math.Max(0.0, position.Length - radius);
    }
}
