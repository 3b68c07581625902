using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Time;

namespace Msisf.Core.Scene;

/// <summary>
/// The motion of a camera from states that are samples of it, in MOON_ME. Positions are those of a polynomial through the eight nearest
/// samples, or of one through four and their velocities; attitudes of <see cref="AttitudePath"/>. Safe for several threads.
/// </summary>
public sealed class SampledMotion
{
    /// <summary>s: as long before and after a time the camera is looked at to know its turning, where the samples do not say it.</summary>
    private const double HalfStep = 0.005;

    private readonly StateSamples _positions = new();
    private readonly UnitQuaternion[] _attitudes;
    private readonly AttitudeSamples _turning = new() { Interpolation = new(InterpolationMethod.Hermite, 3) };
    private readonly AttitudePath _path;

    /// <summary>Takes the samples.</summary>
    /// <param name="states">At least one; their times rise.</param>
    /// <param name="positions">Hermite needs all velocities; linear, or Lagrange.</param>
    /// <param name="path">How attitudes between samples are found; Hermite's needs all rates.</param>
    public SampledMotion(IReadOnlyList<SpacecraftState> states, InterpolationMethod positions, AttitudePath path)
    {
        Start = states[0].Time;
        _path = path;
        _attitudes = [.. states.Select(state => state.MoonFromCamera)];
        _positions.Interpolation = positions == InterpolationMethod.Linear ? new Interpolation(positions, 1) : new(positions, 7);
        foreach (SpacecraftState state in states)
        {
            _positions.Add(
                state.Time.SecondsSince(Start), new StateVector(state.PositionBodyFixed, state.Motion?.VelocityBodyFixed ?? default));
            _turning.Add(_positions.Times.Last, state.MoonFromCamera, state.Motion?.AngularVelocityCamera);
        }
    }

    /// <summary>Time of the first sample.</summary>
    public Instant Start { get; }

    /// <summary>s after <see cref="Start"/>: time of the last sample.</summary>
    public double End => _positions.Times.Last.Seconds;

    /// <summary>The camera at a time.</summary>
    /// <param name="seconds">s after <see cref="Start"/>, from 0 to <see cref="End"/>.</param>
    public CameraState At(double seconds)
    {
        int first = Math.Clamp(_positions.Times.LastAtOrBefore(seconds), 0, Math.Max(0, _attitudes.Length - 2));
        int second = Math.Min(first + 1, _attitudes.Length - 1);
        double length = _positions.Times[second] - _positions.Times[first];
        double part = length == 0.0 ? 0.0 : (seconds - _positions.Times[first]) / length;
        UnitQuaternion attitude = _path switch
        {
            AttitudePath.Hermite => _turning.At(seconds),
            AttitudePath.Squad => Squad.At(
                first > 0 ? _attitudes[first - 1] : null, _attitudes[first], _attitudes[second],
                second + 1 < _attitudes.Length ? _attitudes[second + 1] : null, part),
            _ => Squad.Between(_attitudes[first], _attitudes[second], part),
        };
        return new CameraState(_positions.At(seconds).Position, attitude, seconds);
    }

    /// <summary>How the camera moves at a time.</summary>
    /// <param name="seconds">s after <see cref="Start"/>, from 0 to <see cref="End"/>.</param>
    public CameraMotion MotionAt(double seconds)
    {
        (double from, double to) = (Math.Max(0.0, seconds - HalfStep), Math.Min(End, seconds + HalfStep));
        return new CameraMotion(
            _positions.At(seconds).Velocity,
            _path == AttitudePath.Hermite && _turning.RateAt(seconds) is { } rate
                ? rate
                : CameraMotion.Between((default, At(from).MoonFromCamera), (default, At(to).MoonFromCamera), to - from)
                    .AngularVelocityCamera);
    }
}

/// <summary>How attitudes between samples are found.</summary>
public enum AttitudePath
{
    /// <summary>By a turn at a constant rate from sample to sample; the default.</summary>
    Slerp,

    /// <summary>By <see cref="Attitude.Squad"/>, whose rate does not jump.</summary>
    Squad,

    /// <summary>By cubic polynomials through neighbouring samples, with their angular velocities.</summary>
    Hermite,
}
