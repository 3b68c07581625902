using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Time;

namespace Msisf.Core.Attitude;

/// <summary>
/// Attitudes given by Euler angles and their derivatives at rising times: the angles between samples are those of polynomials, so that
/// angles that grow at constant rates do so between the samples too.
/// </summary>
/// <param name="sequence">The axes of the angles.</param>
/// <param name="turnsToBody">Whether the angles turn the frame's components into the body's; otherwise the reverse.</param>
public sealed class EulerAngleSamples(EulerSequence sequence, bool turnsToBody) : IAttitudeSamples
{
    private readonly StateSamples _angles = new();

    /// <summary>How angles between samples are found.</summary>
    public Interpolation Interpolation
    {
        get => _angles.Interpolation;
        init => _angles.Interpolation = value;
    }

    /// <summary>The times at which the file lets its attitudes be used; null for all.</summary>
    public TdbInterval? Useable
    {
        get => _angles.Useable;
        init => _angles.Useable = value;
    }

    /// <inheritdoc/>
    public SampleTimes Times => _angles.Times;

    /// <inheritdoc/>
    public TdbInterval Cover => _angles.Cover;

    /// <summary>Adds a sample. Angles count on past a full turn, as the derivatives say.</summary>
    /// <param name="time">After that of the last sample.</param>
    /// <param name="angles">rad, in the order of the turns.</param>
    /// <param name="rates">rad/s.</param>
    public void Add(TdbTime time, Vector3D angles, Vector3D rates)
    {
        if (_angles.Count > 0)
        {
            StateVector last = _angles[_angles.Count - 1];
            Vector3D expected = last.Position + (0.5 * (time - Times.Last) * (last.Velocity + rates));
            angles = new Vector3D(Near(expected.X, angles.X), Near(expected.Y, angles.Y), Near(expected.Z, angles.Z));
        }

        _angles.Add(time, new StateVector(angles, rates));

        static double Near(double expected, double angle) => angle + (Math.Tau * Math.Round((expected - angle) / Math.Tau));
    }

    /// <inheritdoc/>
    public UnitQuaternion At(TdbTime time)
    {
        Vector3D angles = _angles.At(time).Position;
        UnitQuaternion turned = sequence.FrameFromBody([angles.X, angles.Y, angles.Z]);
        return turnsToBody ? turned.Conjugate : turned;
    }

    /// <inheritdoc/>
    public Vector3D? RateAt(TdbTime time)
    {
        StateVector state = _angles.At(time);
        (Vector3D angles, Vector3D rates) = (state.Position, state.Velocity);
        Vector3D rate = sequence.RateBody([angles.X, angles.Y, angles.Z], [rates.X, rates.Y, rates.Z]);
        return turnsToBody ? -(At(time).Conjugate * rate) : rate;
    }
}
