namespace Msisf.Benchmarks.Definitions;

/// <summary>
/// Repeated measurements of one thing. On a machine that others use too, the minimum is nearest to the truth and the median to what one
/// sees.
/// </summary>
internal sealed class Samples
{
    private readonly double[] _sorted;

    /// <summary>Takes the values; at least one.</summary>
    public Samples(IEnumerable<double> values)
    {
        _sorted = [.. values.Order()];
        ArgumentOutOfRangeException.ThrowIfZero(_sorted.Length, nameof(values));
    }

    public int Count => _sorted.Length;

    public double Minimum => _sorted[0];

    public double Maximum => _sorted[^1];

    public double Median
    {
        get
        {
            int middle = _sorted.Length / 2;
            return _sorted.Length % 2 == 1 ? _sorted[middle] : (_sorted[middle - 1] + _sorted[middle]) / 2.0;
        }
    }
}
