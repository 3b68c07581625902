using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Time;

namespace Msisf.Core.Scene;

/// <summary>
/// The motion of a camera from states that are samples of it, in MOON_ME. Positions are those of a polynomial through the eight nearest
/// samples, or of one through four and their velocities. Safe for several threads.
/// </summary>
public sealed class SampledMotion
{
    private readonly StateSamples _positions = new();
    private readonly UnitQuaternion[] _attitudes;
    private readonly bool _isSmooth;

    /// <summary>Takes the samples.</summary>
    /// <param name="states">At least one; their times rise.</param>
    /// <param name="positions">Hermite needs all velocities; linear, or Lagrange.</param>
    /// <param name="isSmooth">Whether the rate of turning does not jump (<see cref="Squad"/>); else it is constant between samples.</param>
    public SampledMotion(IReadOnlyList<SpacecraftState> states, InterpolationMethod positions, bool isSmooth)
    {
        Start = states[0].Time;
        _isSmooth = isSmooth;
        _attitudes = [.. states.Select(state => state.MoonFromCamera)];
        _positions.Interpolation = positions == InterpolationMethod.Linear ? new Interpolation(positions, 1) : new(positions, 7);
        foreach (SpacecraftState state in states)
        {
            _positions.Add(
                state.Time.SecondsSince(Start), new StateVector(state.PositionBodyFixed, state.Motion?.VelocityBodyFixed ?? default));
        }
    }

    /// <summary>Time of the first sample.</summary>
    public ModifiedJulianDate Start { get; }

    /// <summary>s after <see cref="Start"/>: time of the last sample.</summary>
    public double End => _positions.Times.Last;

    /// <summary>The camera at a time.</summary>
    /// <param name="seconds">s after <see cref="Start"/>, from 0 to <see cref="End"/>.</param>
    public CameraState At(double seconds)
    {
        int first = Math.Clamp(_positions.Times.LastAtOrBefore(seconds), 0, Math.Max(0, _attitudes.Length - 2));
        int second = Math.Min(first + 1, _attitudes.Length - 1);
        double length = _positions.Times[second] - _positions.Times[first];
        double part = length == 0.0 ? 0.0 : (seconds - _positions.Times[first]) / length;
        UnitQuaternion attitude = _isSmooth
            ? Squad.At(
                first > 0 ? _attitudes[first - 1] : null, _attitudes[first], _attitudes[second],
                second + 1 < _attitudes.Length ? _attitudes[second + 1] : null, part)
            : Squad.Between(_attitudes[first], _attitudes[second], part);
        return new CameraState(_positions.At(seconds).Position, attitude, seconds);
    }
}
