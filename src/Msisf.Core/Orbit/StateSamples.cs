using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Core.Orbit;

/// <summary>
/// States of a spacecraft at rising times, and those between them: one block of a file, in its frame and about its centre. It takes
/// 64 bytes a state.
/// </summary>
public sealed class StateSamples
{
    private readonly SampleTimes _times = new();
    private readonly LongList<Vector3D> _positions = new();
    private readonly LongList<Vector3D> _velocities = new();

    /// <summary>How states between samples are found.</summary>
    public Interpolation Interpolation { get; set; } = new(InterpolationMethod.Hermite, 7);

    /// <summary>The times at which the file lets its states be used; null for all.</summary>
    public TdbInterval? Useable { get; set; }

    /// <summary>Number of samples.</summary>
    public int Count => _times.Count;

    /// <summary>The times of the samples.</summary>
    public SampleTimes Times => _times;

    /// <summary>Whether velocities are given: writers without any write zeros.</summary>
    public bool HasVelocities { get; private set; }

    /// <summary>When the block holds; there must be a sample.</summary>
    public TdbInterval Cover => Useable is { } useable
        ? new TdbInterval(Math.Max(useable.Start, _times.First.Seconds), Math.Min(useable.End, _times.Last.Seconds))
        : new TdbInterval(_times.First.Seconds, _times.Last.Seconds);

    /// <summary>Adds a sample.</summary>
    /// <param name="time">After that of the last sample.</param>
    /// <param name="state">Position (m) and velocity (m/s).</param>
    public void Add(TdbTime time, StateVector state)
    {
        _times.Add(time);
        _positions.Add(state.Position);
        _velocities.Add(state.Velocity);
        HasVelocities |= state.Velocity != default;
    }

    /// <summary>The state of a sample.</summary>
    /// <param name="index">From 0 to below <see cref="Count"/>.</param>
    public StateVector this[int index] => new(_positions[index], _velocities[index]);

    /// <summary>The state at a time.</summary>
    /// <param name="time">Within the samples.</param>
    /// <returns>
    /// Position (m) and velocity (m/s). The velocity is the derivative of Hermite's polynomial; with Lagrange's it is the sum of the
    /// samples' own velocities with the same weights, as in SPICE, or without them the derivative.
    /// </returns>
    public StateVector At(TdbTime time)
    {
        (int first, int count) = _times.Around(time, Interpolation.Samples);
        Span<double> times = stackalloc double[count];
        _times.CopyTo(first, time, times);

        // Sums of differences from one of the positions keep the digits that a change of 1e-10 of the distance needs.
        Vector3D origin = _positions[first];
        Vector3D position = default;
        Vector3D velocity = default;
        if (Interpolation.Method == InterpolationMethod.Hermite)
        {
            Span<(double Value, double Rate)> ofValues = stackalloc (double, double)[count];
            Span<(double Value, double Rate)> ofRates = stackalloc (double, double)[count];
            SampleWeights.Hermite(times, 0.0, ofValues, ofRates);
            for (int i = 0; i < count; i++)
            {
                (Vector3D offset, Vector3D rate) = (_positions[first + i] - origin, _velocities[first + i]);
                position += (ofValues[i].Value * offset) + (ofRates[i].Value * rate);
                velocity += (ofValues[i].Rate * offset) + (ofRates[i].Rate * rate);
            }
        }
        else
        {
            Span<double> values = stackalloc double[count];
            Span<double> rates = stackalloc double[count];
            SampleWeights.Lagrange(times, 0.0, values, rates);
            for (int i = 0; i < count; i++)
            {
                Vector3D offset = _positions[first + i] - origin;
                position += values[i] * offset;
                velocity += HasVelocities ? values[i] * _velocities[first + i] : rates[i] * offset;
            }
        }

        return new StateVector(origin + position, count == 1 ? _velocities[first] : velocity);
    }
}
