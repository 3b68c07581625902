using Msisf.Core.Time;

namespace Msisf.Core.Camera;

/// <summary>The axis of the camera about which it turns: x right, y down, z forward.</summary>
public enum JitterAxis
{
    /// <summary>About y, which a camera that scans downwards flies along: it looks more to the right.</summary>
    Roll,

    /// <summary>About x, along the rows: it looks more to the top of the image.</summary>
    Pitch,

    /// <summary>About z, the line of sight: its right side turns down.</summary>
    Yaw,
}

/// <summary>A sine of a camera's jitter: amplitude times the sine of 2 pi frequency t + phase.</summary>
/// <param name="Axis">About which it turns, right-handed.</param>
/// <param name="Frequency">Hz.</param>
/// <param name="Amplitude">rad.</param>
/// <param name="Phase">rad, at the time 0.</param>
public readonly record struct JitterSine(JitterAxis Axis, double Frequency, double Amplitude, double Phase);

/// <summary>
/// Small turns of a camera about its own axes: it is turned by roll, then about the turned axes by pitch, then by yaw. Either a sum of
/// sines,
/// or samples with cubic polynomials through four neighbours between them. Immutable.
/// </summary>
public sealed class Jitter
{
    private const int SamplesOfPolynomial = 4;

    /// <summary>The axes along the camera's own: it looks along -x, y is right, z up.</summary>
    private static readonly Vector3D Down = -Vector3D.UnitZ;

    private static readonly Vector3D Forward = -Vector3D.UnitX;

    private readonly IReadOnlyList<JitterSine> _sines;
    private readonly SampleTimes _times = new();
    private readonly Vector3D[] _samples;

    /// <summary>A sum of sines, which holds at all times.</summary>
    public Jitter(IReadOnlyList<JitterSine> sines) => (_sines, _samples) = (sines, []);

    /// <summary>Samples.</summary>
    /// <param name="samples">Times (s), rising, with roll, pitch and yaw (rad) as x, y and z; at least one.</param>
    public Jitter(IReadOnlyList<(double Seconds, Vector3D Angles)> samples)
    {
        _sines = [];
        _samples = [.. samples.Select(sample => sample.Angles)];
        foreach ((double seconds, _) in samples)
        {
            _times.Add(seconds);
        }
    }

    /// <summary>s: from when to when it is known.</summary>
    public (double Start, double End) Cover => _samples.Length == 0
        ? (double.NegativeInfinity, double.PositiveInfinity)
        : (_times.First.Seconds, _times.Last.Seconds);

    /// <summary>Roll, pitch and yaw, rad, as x, y and z.</summary>
    /// <param name="seconds">s, inside <see cref="Cover"/>.</param>
    public Vector3D AnglesAt(double seconds)
    {
        if (_samples.Length > 0)
        {
            return Interpolated(seconds);
        }

        Span<double> angles = stackalloc double[3];
        foreach (JitterSine sine in _sines)
        {
            angles[(int)sine.Axis] += sine.Amplitude * Trigonometry.Sin((2.0 * Math.PI * sine.Frequency * seconds) + sine.Phase);
        }

        return new Vector3D(angles[0], angles[1], angles[2]);
    }

    /// <summary>Turns a camera.</summary>
    /// <param name="seconds">s.</param>
    public UnitQuaternion Turn(UnitQuaternion moonFromCamera, double seconds)
    {
        Vector3D angles = AnglesAt(seconds);
        return moonFromCamera * UnitQuaternion.FromAxisAngle(Down, angles.X) * UnitQuaternion.FromAxisAngle(Vector3D.UnitY, angles.Y)
            * UnitQuaternion.FromAxisAngle(Forward, angles.Z);
    }

    private Vector3D Interpolated(double seconds)
    {
        if (!(seconds >= _times.First.Seconds && seconds <= _times.Last.Seconds))
        {
            throw new BadInputException(FormattableString.Invariant(
                $"the jitter is known from {_times.First.Seconds:R} s to {_times.Last.Seconds:R} s, and {seconds:R} s is needed."));
        }

        (int first, int count) = _times.Around(seconds, SamplesOfPolynomial);
        Span<double> times = stackalloc double[count];
        Span<double> weights = stackalloc double[count];
        _times.CopyTo(first, seconds, times);
        SampleWeights.Lagrange(times, 0.0, weights, stackalloc double[count]);
        Vector3D sum = default;
        for (int i = 0; i < count; i++)
        {
            sum += weights[i] * _samples[first + i];
        }

        return sum;
    }
}
