using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>Turns states that turn with the Moon into those along J2000's axes, and the reverse.</summary>
public static class TurningMoon
{
    /// <summary>A state along J2000's axes.</summary>
    /// <param name="state">Position (m) and velocity (m/s) along the axes of a frame that turns with the Moon, and over it.</param>
    /// <param name="moonMeFromFrame">The constant rotation of that frame.</param>
    public static StateVector ToJ2000(StateVector state, RotationMatrix moonMeFromFrame, TdbTime time, IEphemeris ephemeris)
    {
        StateVector along = ephemeris.BodyFromJ2000(time).Transposed * moonMeFromFrame * state;
        return along with { Velocity = along.Velocity + Vector3D.Cross(ephemeris.BodyRateJ2000(time), along.Position) };
    }

    /// <summary>A state along the axes of MOON_ME, with the velocity over the turning Moon.</summary>
    /// <param name="state">Position (m) and velocity (m/s) along J2000's axes.</param>
    public static StateVector ToBodyFixed(StateVector state, TdbTime time, IEphemeris ephemeris) => ephemeris.BodyFromJ2000(time)
        * (state with { Velocity = state.Velocity - Vector3D.Cross(ephemeris.BodyRateJ2000(time), state.Position) });

    /// <summary>How fast the Moon turns: rad/s relative to J2000, along its own axes.</summary>
    public static Vector3D RateBodyFixed(TdbTime time, IEphemeris ephemeris) =>
        ephemeris.BodyFromJ2000(time) * ephemeris.BodyRateJ2000(time);
}
