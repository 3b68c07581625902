using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Adapters.Ephemeris;

/// <summary>
/// SPK types 8 and 9 (Lagrange), 12 and 13 (Hermite), 18 (ESOC's of both kinds): states, with polynomials through those nearest to a time.
/// </summary>
/// <remarks>NAIF, SPK Required Reading, "Type 8" to "Type 18".</remarks>
internal sealed class SpkStates : SpkSegment
{
    private const int MaximumWindow = 32;

    private readonly int _count;
    private readonly int _window;
    private readonly int _packet = 6;
    private readonly bool _isHermite;
    private readonly bool _narrowsAtEnds;
    private readonly (double Start, double Step)? _steps;
    private readonly Lazy<double[]> _epochs;

    /// <summary>Reads the segment's sizes.</summary>
    /// <param name="file">The kernel; must outlive the segment.</param>
    /// <param name="type">8, 9, 12, 13 or 18.</param>
    /// <exception cref="BadInputException">They contradict each other.</exception>
    public SpkStates(DafFile file, DafSummary summary, int type)
        : base(file, summary)
    {
        if (type == 18)
        {
            bool isLagrange = Words.Whole(fromEnd: 3, min: 0, max: 1) == 1;
            (_isHermite, _packet, _narrowsAtEnds) = (!isLagrange, isLagrange ? 6 : 12, true);
        }
        else
        {
            _isHermite = type is 12 or 13;
        }

        bool isEven = type is 8 or 12;
        _count = Words.Whole(fromEnd: 1, min: 1, Words.Count / _packet);
        _window = type == 18
            ? Words.Whole(fromEnd: 2, min: 2, MaximumWindow)
            : Words.Whole(fromEnd: 2, min: 0, MaximumWindow - 1) + 1;
        if ((long)_count * (_packet + (isEven ? 0 : 1)) > Words.Count || (_window > _count && !_narrowsAtEnds))
        {
            throw Words.Damaged($"{_count} states with polynomials through {_window} do not fit its size");
        }

        if (isEven)
        {
            double[] steps = Words.Read(Words.Count - 4, 2);
            _steps = steps[1] > 0.0 ? (steps[0], steps[1]) : throw Words.Damaged("its states have no distance");
        }

        _epochs = new Lazy<double[]>(() => isEven ? [] : Words.ReadRising((long)_count * _packet, _count));
    }

    public override StateVector StateAt(TdbTime tdb)
    {
        (int first, int count) = WindowAt(tdb);
        Span<double> times = stackalloc double[count];
        for (int i = 0; i < count; i++)
        {
            // Relative to the first one, so that nothing is lost by the seconds since 2000.
            times[i] = _steps is { } even ? i * even.Step : _epochs.Value[first + i] - _epochs.Value[first];
        }

        double time = tdb - (_steps is { } steps ? steps.Start + (first * steps.Step) : _epochs.Value[first]);
        double[] packets = Words.Read((long)first * _packet, count * _packet);
        return _isHermite ? Hermite(packets, times, time) : Lagrange(packets, times, time);
    }

    /// <summary>The states through which the polynomial for a time goes.</summary>
    private (int First, int Count) WindowAt(TdbTime tdb)
    {
        double position = _steps is { } even ? (tdb - even.Start) / even.Step : 0.0;
        int low = _steps is not null
            ? (int)Math.Clamp(Math.Truncate(position), 0.0, _count - 1.0)
            : Math.Max(0, LastBefore(tdb));
        if (_narrowsAtEnds)
        {
            int first = Math.Max(0, low - (_window / 2) + 1);
            return (first, Math.Min(_count, low + 1 + (_window / 2)) - first);
        }

        if (_window % 2 == 1)
        {
            low = _steps is not null
                ? (int)Math.Clamp(Math.Round(position, MidpointRounding.AwayFromZero), 0.0, _count - 1.0)
                : Nearest(low, tdb);
        }

        return (Math.Clamp(low - ((_window - 1) / 2), 0, _count - _window), _window);
    }

    private int LastBefore(TdbTime tdb)
    {
        int found = Array.BinarySearch(_epochs.Value, tdb.Seconds);
        return (found < 0 ? ~found : found) - 1;
    }

    private int Nearest(int low, TdbTime tdb) =>
        low + 1 == _count || Math.Abs(tdb - _epochs.Value[low]) < Math.Abs(tdb - _epochs.Value[low + 1]) ? low : low + 1;

    private StateVector Lagrange(ReadOnlySpan<double> packets, ReadOnlySpan<double> times, double time)
    {
        Span<double> weights = stackalloc double[times.Length];
        SampleWeights.Lagrange(times, time, weights, stackalloc double[times.Length]);
        StateVector state = default;
        for (int i = 0; i < times.Length; i++)
        {
            state += weights[i] * StateOf(packets, i, 0);
        }

        return state;
    }

    /// <summary>The second half of a packet of type 18 is velocity and acceleration, which have a polynomial of their own.</summary>
    private StateVector Hermite(ReadOnlySpan<double> packets, ReadOnlySpan<double> times, double time)
    {
        Span<(double Value, double Rate)> ofValues = stackalloc (double, double)[times.Length];
        Span<(double Value, double Rate)> ofRates = stackalloc (double, double)[times.Length];
        SampleWeights.Hermite(times, time, ofValues, ofRates);
        Vector3D position = default;
        Vector3D velocity = default;
        for (int i = 0; i < times.Length; i++)
        {
            StateVector sample = StateOf(packets, i, 0);
            position += (ofValues[i].Value * sample.Position) + (ofRates[i].Value * sample.Velocity);
            if (_packet == 6)
            {
                velocity += (ofValues[i].Rate * sample.Position) + (ofRates[i].Rate * sample.Velocity);
            }
            else
            {
                StateVector rates = StateOf(packets, i, 6);
                velocity += (ofValues[i].Value * rates.Position) + (ofRates[i].Value * rates.Velocity);
            }
        }

        return new StateVector(position, velocity);
    }

    private StateVector StateOf(ReadOnlySpan<double> packets, int index, int offset)
    {
        ReadOnlySpan<double> s = packets.Slice((index * _packet) + offset, 6);
        return new StateVector(new Vector3D(s[0], s[1], s[2]), new Vector3D(s[3], s[4], s[5]));
    }
}
