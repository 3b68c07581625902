using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Core.Attitude;

/// <summary>The attitude of a spacecraft on its orbit, given in one of several frames. As thread-safe as its ephemeris.</summary>
public sealed class FramedAttitude : IAttitudeSource
{
    private readonly AttitudeTransition _attitude;
    private readonly AttitudeFrame _frame;
    private readonly Instant? _epoch;
    private readonly IEphemeris? _ephemeris;
    private readonly RotationMatrix _j2000FromFrame;

    /// <summary>Takes the attitude.</summary>
    /// <param name="attitude">Turns camera axes into those of <paramref name="frame"/>, from the epoch on.</param>
    /// <param name="epoch">Epoch of the attitude; null where it does not change in its frame.</param>
    /// <param name="ephemeris">How the Moon turns; only the frames at rest need it.</param>
    /// <exception cref="ArgumentNullException">The frame is at rest, and there is no ephemeris.</exception>
    /// <exception cref="Errors.SpiceException">
    /// The epoch is outside the kernels' cover (<see cref="AttitudeFrame.MoonMeEpoch"/>).
    /// </exception>
    public FramedAttitude(AttitudeTransition attitude, AttitudeFrame frame, Instant? epoch, IEphemeris? ephemeris)
    {
        if (frame is AttitudeFrame.MoonMeEpoch or AttitudeFrame.J2000)
        {
            ArgumentNullException.ThrowIfNull(ephemeris);
        }

        (_attitude, _frame, _epoch, _ephemeris) = (attitude, frame, epoch, ephemeris);
        _j2000FromFrame = frame == AttitudeFrame.MoonMeEpoch
            ? ephemeris!.BodyFromJ2000(epoch!.Value.Tdb).Transposed
            : RotationMatrix.Identity;
    }

    /// <inheritdoc/>
    public UnitQuaternion MoonFromCamera(in TrajectoryPoint point)
    {
        Vector3D orbitNormal = point.OrbitNormalBodyFixed;
        return MoonFromCamera(point.Time, point.PositionBodyFixed, _ => orbitNormal);
    }

    /// <inheritdoc/>
    public TurnRate? RateOf(in TrajectoryPoint point)
    {
        Vector3D ofFrame = _frame == AttitudeFrame.Lvlh
            ? MoonFromCamera(point).Conjugate * (point.OrbitNormalBodyFixed / point.StateJ2000.Position.LengthSquared)
            : default;
        return new TurnRate(_attitude.AngularVelocityCamera + ofFrame, IsOverBody: _frame == AttitudeFrame.MoonMe);
    }

    /// <summary>How fast the camera turns over the Moon: rad/s about its axes.</summary>
    /// <param name="moonFromCamera">The attitude at the time.</param>
    /// <param name="orbitTurningBodyFixed">
    /// rad/s over the Moon, along its axes: how fast the line to the spacecraft turns with the orbit's plane; asked for
    /// <see cref="AttitudeFrame.Lvlh"/> only.
    /// </param>
    /// <exception cref="Errors.SpiceException">The time is outside the kernels' cover (frames at rest).</exception>
    public Vector3D RateOverBody(Instant time, UnitQuaternion moonFromCamera, Func<Instant, Vector3D> orbitTurningBodyFixed)
    {
        Vector3D ofFrame = _frame switch
        {
            AttitudeFrame.MoonMe => default,
            AttitudeFrame.Lvlh => orbitTurningBodyFixed(time),
            _ => -TurningMoon.RateBodyFixed(time.Tdb, _ephemeris!),
        };
        return _attitude.AngularVelocityCamera + (moonFromCamera.Conjugate * ofFrame);
    }

    /// <summary>The attitude at a time.</summary>
    /// <param name="positionBodyFixed">Spacecraft, m, body-fixed; not the centre.</param>
    /// <param name="orbitNormalBodyFixed">
    /// Direction of the orbit's angular momentum at a time, body-fixed, any length; asked for <see cref="AttitudeFrame.Lvlh"/> only.
    /// </param>
    /// <returns>Turns camera axes (looks along -x, y right, z up) into Moon axes.</returns>
    /// <exception cref="Errors.SpiceException">The time is outside the kernels' cover (frames at rest).</exception>
    public UnitQuaternion MoonFromCamera(
        Instant time, Vector3D positionBodyFixed, Func<Instant, Vector3D> orbitNormalBodyFixed)
    {
        UnitQuaternion frameFromCamera = _attitude.At(_epoch is { } epoch ? time.SecondsSince(epoch) : 0.0);
        return _frame switch
        {
            AttitudeFrame.MoonMe => frameFromCamera,
            AttitudeFrame.Lvlh => UnitQuaternion.FromMatrix(MoonFromLvlh(positionBodyFixed, orbitNormalBodyFixed(time))) * frameFromCamera,
            _ => UnitQuaternion.FromMatrix(_ephemeris!.BodyFromJ2000(time.Tdb) * _j2000FromFrame) * frameFromCamera,
        };
    }

    private static RotationMatrix MoonFromLvlh(Vector3D position, Vector3D orbitNormal)
    {
        Vector3D down = -position.Normalized();
        Vector3D forward = Vector3D.Cross(orbitNormal, position).Normalized();
        return new RotationMatrix(forward, Vector3D.Cross(down, forward), down).Transposed;
    }
}

/// <summary>The axes into which the quaternion of an attitude turns the camera's axes (docs/camera-model.md).</summary>
public enum AttitudeFrame
{
    /// <summary>MOON_ME at the time of the image, which turns with the Moon; the default.</summary>
    MoonMe,

    /// <summary>The MOON_ME axes of the epoch, held inertial.</summary>
    MoonMeEpoch,

    /// <summary>J2000 (ICRF) axes.</summary>
    J2000,

    /// <summary>
    /// Local vertical, local horizontal: z to the Moon's centre, y against the orbit's angular momentum, x across both, forward.
    /// </summary>
    Lvlh,
}
