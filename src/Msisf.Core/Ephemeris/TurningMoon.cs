using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>Turns states that turn with the Moon into those along J2000's axes, and the reverse.</summary>
public static class TurningMoon
{
    /// <summary>s: the turning of a frame is a difference of its axes this long before and after.</summary>
    private const double HalfStep = 1.0;

    /// <summary>A state along J2000's axes.</summary>
    /// <param name="state">Position (m) and velocity (m/s) along the axes of a frame that turns with the Moon, and over it.</param>
    /// <param name="moonMeFromFrame">The constant rotation of that frame.</param>
    public static StateVector ToJ2000(StateVector state, RotationMatrix moonMeFromFrame, TdbTime time, IEphemeris ephemeris)
    {
        RotationMatrix j2000FromFrame = J2000FromBody(time) * moonMeFromFrame;
        Vector3D later = J2000FromBody(time + HalfStep) * moonMeFromFrame * state.Position;
        Vector3D earlier = J2000FromBody(time + -HalfStep) * moonMeFromFrame * state.Position;
        return new StateVector(
            j2000FromFrame * state.Position, (j2000FromFrame * state.Velocity) + ((later - earlier) / (2.0 * HalfStep)));

        RotationMatrix J2000FromBody(TdbTime at) => ephemeris.BodyFromJ2000(at).Transposed;
    }

    /// <summary>How fast the Moon turns: rad/s relative to J2000, along its own axes.</summary>
    public static Vector3D RateBodyFixed(TdbTime time, IEphemeris ephemeris)
    {
        RotationMatrix turn = ephemeris.BodyFromJ2000(time + -HalfStep) * ephemeris.BodyFromJ2000(time + HalfStep).Transposed;
        return 0.5 / (2.0 * HalfStep)
            * new Vector3D(turn.Row2.Y - turn.Row1.Z, turn.Row0.Z - turn.Row2.X, turn.Row1.X - turn.Row0.Y);
    }
}
