using Msisf.Core.Ephemeris;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.Adapters.States;

/// <summary>A camera at a time, about the Moon and along J2000's axes.</summary>
/// <param name="TdbSeconds">TDB seconds past J2000, the nearest double.</param>
/// <param name="Time">When.</param>
/// <param name="State">Position (m) and velocity (m/s) relative to the Moon's centre.</param>
/// <param name="J2000FromCamera">Turns camera axes (looks along -x, y right, z up) into J2000's.</param>
/// <param name="RateJ2000">rad/s of the camera relative to J2000, along its axes; null where nothing says it.</param>
public readonly record struct InertialState(
    double TdbSeconds, Instant Time, StateVector State, UnitQuaternion J2000FromCamera, Vector3D? RateJ2000)
{
    /// <summary>Neighbours whose positions give a velocity that no state says: a polynomial of degree 7.</summary>
    private const int Neighbours = 8;

    /// <summary>The states of a run in the order of time.</summary>
    /// <param name="states">States in MOON_ME, at least one.</param>
    /// <param name="ephemeris">How the Moon turns.</param>
    /// <exception cref="BadInputException">Two states are of one time.</exception>
    public static InertialState[] Of(IReadOnlyList<SpacecraftState> states, IEphemeris ephemeris)
    {
        SpacecraftState[] sorted = [.. states.OrderBy(state => state.Time)];
        SampleTimes times = new();
        Vector3D[] positions = new Vector3D[sorted.Length];
        RotationMatrix[] j2000FromBody = new RotationMatrix[sorted.Length];
        for (int i = 0; i < sorted.Length; i++)
        {
            TdbTime time = sorted[i].Time.Tdb;
            if (i > 0 && !(time.Seconds > times.Last.Seconds))
            {
                throw new BadInputException(
                    $"two states of the run are of {sorted[i].Time.ToIsoUtc()}: a trajectory is at one place then. Choose other times, or "
                        + "--format batch.");
            }

            times.Add(time);
            j2000FromBody[i] = ephemeris.BodyFromJ2000(time).Transposed;
            positions[i] = j2000FromBody[i] * sorted[i].PositionBodyFixed;
        }

        return [.. sorted.Select((state, i) => new InertialState(
            times[i].Seconds, state.Time,
            new StateVector(positions[i], state.Motion is { } motion
                ? TurningMoon.ToJ2000(
                    new StateVector(state.PositionBodyFixed, motion.VelocityBodyFixed), RotationMatrix.Identity, times[i],
                    ephemeris).Velocity
                : Velocity(times, positions, i)),
            UnitQuaternion.FromMatrix(j2000FromBody[i]) * state.MoonFromCamera,
            state.Motion is { } turning
                ? j2000FromBody[i] * (TurningMoon.RateBodyFixed(times[i], ephemeris)
                    + (state.MoonFromCamera * turning.AngularVelocityCamera))
                : null))];
    }

    /// <summary>The derivative of the polynomial through the neighbours' positions; 0 for one state alone.</summary>
    private static Vector3D Velocity(SampleTimes times, Vector3D[] positions, int index)
    {
        (int first, int count) = times.Around(times[index], Neighbours);
        Span<double> offsets = stackalloc double[count];
        times.CopyTo(first, times[index], offsets);
        Span<double> rates = stackalloc double[count];
        SampleWeights.Lagrange(offsets, 0.0, stackalloc double[count], rates);
        Vector3D velocity = default;
        for (int i = 0; i < count; i++)
        {
            velocity += rates[i] * (positions[first + i] - positions[index]);
        }

        return velocity;
    }
}
