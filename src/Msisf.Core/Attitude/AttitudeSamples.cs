using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Core.Attitude;

/// <summary>
/// Attitudes of a spacecraft at rising times, and those between them: one block of a file, in its frame. It takes 48 bytes an attitude,
/// 80 with rates.
/// </summary>
public sealed class AttitudeSamples : IAttitudeSamples
{
    private readonly SampleTimes _times = new();
    private readonly LongList<Components> _attitudes = new();
    private readonly LongList<Components> _rates = new();

    /// <summary>How attitudes between samples are found.</summary>
    public Interpolation Interpolation { get; set; }

    /// <summary>The times at which the file lets its attitudes be used; null for all.</summary>
    public TdbInterval? Useable { get; set; }

    /// <summary>Number of samples.</summary>
    public int Count => _times.Count;

    /// <summary>The times of the samples.</summary>
    public SampleTimes Times => _times;

    /// <summary>When the block holds; there must be a sample.</summary>
    public TdbInterval Cover => Useable is { } useable
        ? new TdbInterval(Math.Max(useable.Start, _times.First.Seconds), Math.Min(useable.End, _times.Last.Seconds))
        : new TdbInterval(_times.First.Seconds, _times.Last.Seconds);

    /// <summary>Adds a sample. q and -q are one attitude: the one that is nearer to the last sample is kept.</summary>
    /// <param name="time">After that of the last sample.</param>
    /// <param name="frameFromBody">Turns the body's axes into those of the frame.</param>
    /// <param name="rateBody">rad/s about the body's axes; of all samples or of none, and of all for Hermite's interpolation.</param>
    public void Add(TdbTime time, UnitQuaternion frameFromBody, Vector3D? rateBody = null)
    {
        Components attitude = Components.Of(frameFromBody);
        bool isFar = Count > 0 && Components.Dot(_attitudes[Count - 1], attitude) < 0.0;
        _times.Add(time);
        _attitudes.Add(isFar ? -1.0 * attitude : attitude);
        if (rateBody is { } rate)
        {
            _rates.Add((isFar ? -0.5 : 0.5) * Components.Times(attitude, rate));
        }
    }

    /// <summary>The attitude at a time.</summary>
    /// <param name="time">Within the samples.</param>
    /// <returns>Turns the body's axes into those of the frame.</returns>
    public UnitQuaternion At(TdbTime time)
    {
        (int first, int count) = _times.Around(time, Interpolation.Samples);
        if (count == 1)
        {
            return _attitudes[first].Normalized();
        }

        if (Interpolation.Method == InterpolationMethod.Linear)
        {
            return AtConstantRate(first, time);
        }

        return Polynomial(first, count, time).Value.Normalized();
    }

    /// <inheritdoc/>
    public Vector3D? RateAt(TdbTime time)
    {
        if (_rates.Count == 0)
        {
            return null;
        }

        (int first, int count) = _times.Around(time, Interpolation.Samples);
        if (count == 1)
        {
            return RateOf(_attitudes[first], _rates[first]);
        }

        if (Interpolation.Method == InterpolationMethod.Hermite)
        {
            (Components value, Components rate) = Polynomial(first, count, time);
            return RateOf(value, rate);
        }

        // The rates that the samples state have a polynomial of their own, of the same degree.
        Span<double> times = stackalloc double[count];
        _times.CopyTo(first, time, times);
        Span<double> weights = stackalloc double[count];
        SampleWeights.Lagrange(times, 0.0, weights, stackalloc double[count]);
        Vector3D sum = default;
        for (int i = 0; i < count; i++)
        {
            sum += weights[i] * RateOf(_attitudes[first + i], _rates[first + i]);
        }

        return sum;
    }

    /// <summary>The quaternion of the polynomial, of any length, and its derivative.</summary>
    private (Components Value, Components Rate) Polynomial(int first, int count, TdbTime time)
    {
        Span<double> times = stackalloc double[count];
        _times.CopyTo(first, time, times);
        (Components value, Components rate) = (default, default);
        if (Interpolation.Method == InterpolationMethod.Hermite)
        {
            Span<(double Value, double Rate)> ofValues = stackalloc (double, double)[count];
            Span<(double Value, double Rate)> ofRates = stackalloc (double, double)[count];
            SampleWeights.Hermite(times, 0.0, ofValues, ofRates);
            for (int i = 0; i < count; i++)
            {
                value += (ofValues[i].Value * _attitudes[first + i]) + (ofRates[i].Value * _rates[first + i]);
                rate += (ofValues[i].Rate * _attitudes[first + i]) + (ofRates[i].Rate * _rates[first + i]);
            }
        }
        else
        {
            Span<double> values = stackalloc double[count];
            Span<double> rates = stackalloc double[count];
            SampleWeights.Lagrange(times, 0.0, values, rates);
            for (int i = 0; i < count; i++)
            {
                value += values[i] * _attitudes[first + i];
                rate += rates[i] * _attitudes[first + i];
            }
        }

        return (value, rate);
    }

    /// <summary>rad/s about the body's axes: twice the imaginary part of q* dq, for a q of any length.</summary>
    private static Vector3D RateOf(Components q, Components dq)
    {
        (Vector3D v, Vector3D dv) = (new Vector3D(q.X, q.Y, q.Z), new Vector3D(dq.X, dq.Y, dq.Z));
        return 2.0 / Components.Dot(q, q) * ((q.W * dv) - (dq.W * v) - Vector3D.Cross(v, dv));
    }

    private UnitQuaternion AtConstantRate(int first, TdbTime time)
    {
        UnitQuaternion before = _attitudes[first].Normalized();
        UnitQuaternion turn = before.Conjugate * _attitudes[first + 1].Normalized();
        Vector3D sine = new(turn.X, turn.Y, turn.Z); // of half the angle
        double length = sine.Length;
        if (length == 0.0)
        {
            return before;
        }

        double part = (time - _times[first]) / (_times[first + 1] - _times[first]);
        return before * UnitQuaternion.FromAxisAngle(sine, part * 2.0 * Trigonometry.Atan2(length, turn.W));
    }

    /// <summary>The four numbers of a quaternion, of any length.</summary>
    private readonly record struct Components(double X, double Y, double Z, double W)
    {
        public static Components operator +(Components p, Components q) => new(p.X + q.X, p.Y + q.Y, p.Z + q.Z, p.W + q.W);

        public static Components operator *(double factor, Components q) =>
            new(factor * q.X, factor * q.Y, factor * q.Z, factor * q.W);

        public static Components Of(UnitQuaternion q) => new(q.X, q.Y, q.Z, q.W);

        public static double Dot(Components p, Components q) => (p.X * q.X) + (p.Y * q.Y) + (p.Z * q.Z) + (p.W * q.W);

        /// <summary>The product with the quaternion (v, 0).</summary>
        public static Components Times(Components q, Vector3D v)
        {
            Vector3D imaginary = new(q.X, q.Y, q.Z);
            Vector3D product = (q.W * v) + Vector3D.Cross(imaginary, v);
            return new Components(product.X, product.Y, product.Z, -Vector3D.Dot(imaginary, v));
        }

        public UnitQuaternion Normalized()
        {
            double length = double.Hypot(double.Hypot(X, Y), double.Hypot(Z, W));
            return UnitQuaternion.FromComponents(X / length, Y / length, Z / length, W / length);
        }
    }
}

/// <summary>A part of a file's attitudes, which are of one frame.</summary>
/// <param name="MoonMeFromFrame">
/// For a frame that turns with the Moon, the constant rotation to MOON_ME; null for J2000's axes.
/// </param>
public sealed record AttitudeBlock(IAttitudeSamples Samples, RotationMatrix? MoonMeFromFrame);

/// <summary>Attitudes of a body at rising times, and those between them, in one frame.</summary>
public interface IAttitudeSamples
{
    /// <summary>The times of the samples, TDB seconds past J2000.</summary>
    SampleTimes Times { get; }

    /// <summary>When they hold; there must be a sample.</summary>
    TdbInterval Cover { get; }

    /// <summary>The attitude at a time.</summary>
    /// <param name="time">Within the samples.</param>
    /// <returns>Turns the body's axes into those of the frame.</returns>
    UnitQuaternion At(TdbTime time);

    /// <summary>How fast the body turns in the frame.</summary>
    /// <param name="time">Within the samples.</param>
    /// <returns>rad/s about the body's axes; null if the samples do not say it.</returns>
    Vector3D? RateAt(TdbTime time);
}
