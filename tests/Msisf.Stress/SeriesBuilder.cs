namespace Msisf.Stress;

/// <summary>
/// Sorts errors into bins of the input. Not safe for several threads: each has its own, merged by <see cref="Add(SeriesBuilder)"/>.
/// </summary>
public sealed class SeriesBuilder
{
    private readonly double _from;
    private readonly double _to;
    private readonly bool _isLogarithmic;
    private readonly long[] _counts;
    private readonly double[] _sums;
    private readonly double[] _worst;

    /// <summary>Takes the range of the input; what is beyond goes into the outermost bins.</summary>
    /// <param name="from">Start of the first bin.</param>
    /// <param name="to">End of the last bin.</param>
    /// <param name="bins">How many.</param>
    /// <param name="isLogarithmic">Bins equal in the logarithm; both ends are then above 0.</param>
    public SeriesBuilder(double from, double to, int bins, bool isLogarithmic)
    {
        _from = from;
        _to = to;
        _isLogarithmic = isLogarithmic;
        _counts = new long[bins];
        _sums = new double[bins];
        _worst = new double[bins];
    }

    /// <summary>Notes a case.</summary>
    /// <param name="input">Where in the range.</param>
    /// <param name="error">How wrong; NaN stays the worst of its bin.</param>
    public void Add(double input, double error)
    {
        double place = _isLogarithmic ? Math.Log(input / _from) / Math.Log(_to / _from) : (input - _from) / (_to - _from);
        int bin = (int)Math.Clamp(place * _counts.Length, 0, _counts.Length - 1);
        _counts[bin]++;
        _sums[bin] += error;
        _worst[bin] = Math.Max(_worst[bin], error);
    }

    /// <summary>Notes the cases of another builder of the same range.</summary>
    public void Add(SeriesBuilder other)
    {
        for (int bin = 0; bin < _counts.Length; bin++)
        {
            _counts[bin] += other._counts[bin];
            _sums[bin] += other._sums[bin];
            _worst[bin] = Math.Max(_worst[bin], other._worst[bin]);
        }
    }

    /// <summary>The series so far.</summary>
    public StressSeries ToSeries(string quantity, string unit, string input, string inputUnit, double? limit) =>
        new(quantity, unit, input, inputUnit, _isLogarithmic, limit, [.. Bins()]);

    private IEnumerable<StressBin> Bins()
    {
        for (int bin = 0; bin < _counts.Length; bin++)
        {
            if (_counts[bin] > 0)
            {
                yield return new StressBin(Border(bin), Border(bin + 1), _counts[bin], _sums[bin] / _counts[bin], _worst[bin]);
            }
        }
    }

    private double Border(int bin)
    {
        double share = (double)bin / _counts.Length;
        return _isLogarithmic ? _from * Math.Pow(_to / _from, share) : _from + (share * (_to - _from));
    }
}
