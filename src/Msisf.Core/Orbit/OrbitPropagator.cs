using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Core.Orbit;

/// <summary>Where a spacecraft is at a time, from its orbit at an epoch. As safe for several threads as its ephemeris.</summary>
public sealed class OrbitPropagator
{
    private readonly KeplerOrbit _orbit;
    private readonly Instant _epoch;
    private readonly OrbitFrame _frame;
    private readonly IEphemeris? _ephemeris;
    private readonly RotationMatrix _j2000FromOrbit;

    /// <summary>Takes the orbit. State vectors come in through <see cref="StateConversion.ToElements"/>, which keeps the frame.</summary>
    /// <param name="elements">The orbit at the epoch, in <paramref name="frame"/>.</param>
    /// <param name="epoch">When the mean anomaly is M0.</param>
    /// <param name="ephemeris">How the Moon turns; <see cref="OrbitFrame.MoonMe"/> needs none.</param>
    /// <exception cref="ArgumentException">The elements are <c>default</c>, or the frame turns and there is no ephemeris.</exception>
    /// <exception cref="SpiceException">The epoch is outside the kernels' cover (<see cref="OrbitFrame.MoonMeEpoch"/>).</exception>
    public OrbitPropagator(KeplerElements elements, Instant epoch, OrbitFrame frame, IEphemeris? ephemeris)
    {
        if (frame != OrbitFrame.MoonMe)
        {
            ArgumentNullException.ThrowIfNull(ephemeris);
        }

        _orbit = new KeplerOrbit(elements);
        _epoch = epoch;
        _frame = frame;
        _ephemeris = ephemeris;
        _j2000FromOrbit = frame == OrbitFrame.MoonMeEpoch
            ? ephemeris!.BodyFromJ2000(epoch.Tdb).Transposed
            : RotationMatrix.Identity;
    }

    /// <summary>
    /// Minimum distance from the Moon's centre on the whole orbit, m. It does not tell whether the spacecraft is below the ground, which
    /// depends on the terrain.
    /// </summary>
    public double PeriapsisRadius => _orbit.Elements.PeriapsisRadius;

    /// <summary>Position in m, MOON_ME of the time.</summary>
    /// <exception cref="SpiceException">The time is outside the kernels' cover (not for <see cref="OrbitFrame.MoonMe"/>).</exception>
    /// <exception cref="BadInputException">The orbit is so small that it can't be followed up to the time.</exception>
    public Vector3D PositionBodyFixed(Instant time) => ToBodyFixed(_orbit.PositionAt(time.SecondsSince(_epoch)), time);

    /// <summary>Position in m and velocity in m/s over the turning Moon, along the axes of MOON_ME of the time.</summary>
    /// <inheritdoc cref="PositionBodyFixed"/>
    public StateVector StateBodyFixed(Instant time)
    {
        StateVector state = _orbit.StateAt(time.SecondsSince(_epoch));
        return _frame == OrbitFrame.MoonMe
            ? state
            : TurningMoon.ToBodyFixed(_j2000FromOrbit * state, time.Tdb, _ephemeris!);
    }

    /// <summary>
    /// How fast the line from the Moon's centre to the spacecraft turns over the Moon, and the orbit's plane with it: rad/s along the axes
    /// of MOON_ME of the time.
    /// </summary>
    /// <inheritdoc cref="PositionBodyFixed"/>
    public Vector3D TurningBodyFixed(Instant time)
    {
        StateVector state = _orbit.StateAt(time.SecondsSince(_epoch));
        Vector3D inOrbit = ToBodyFixed(Vector3D.Cross(state.Position, state.Velocity) / state.Position.LengthSquared, time);
        return _frame == OrbitFrame.MoonMe ? inOrbit : inOrbit - TurningMoon.RateBodyFixed(time.Tdb, _ephemeris!);
    }

    /// <summary>Direction of the orbit's angular momentum, length 1, MOON_ME of the time.</summary>
    /// <exception cref="SpiceException">The time is outside the kernels' cover (not for <see cref="OrbitFrame.MoonMe"/>).</exception>
    public Vector3D NormalBodyFixed(Instant time) => ToBodyFixed(_orbit.Normal, time);

    private Vector3D ToBodyFixed(Vector3D vectorOrbit, Instant time) => _frame == OrbitFrame.MoonMe
        ? vectorOrbit
        : _ephemeris!.BodyFromJ2000(time.Tdb) * (_j2000FromOrbit * vectorOrbit);
}

/// <summary>
/// The frame in which elements or state vectors are given and in which the orbit is propagated (docs/deviations.md, row 22).
/// </summary>
public enum OrbitFrame
{
    /// <summary>
    /// MOON_ME treated as if it did not rotate (as in the thesis; the default), although it rotates by 13.18 degrees a day.
    /// </summary>
    MoonMe,

    /// <summary>The MOON_ME axes of the epoch, held inertial.</summary>
    MoonMeEpoch,

    /// <summary>J2000 (ICRF) axes with the Moon in the origin.</summary>
    J2000,
}
