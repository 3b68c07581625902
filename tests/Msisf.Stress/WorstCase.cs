namespace Msisf.Stress;

/// <summary>
/// The maximum error so far and the input that shows it. Not safe for several threads: each has its own, merged by <see cref="Add"/>.
/// </summary>
public sealed class WorstCase
{
    private double _error = double.NaN;
    private string _input = "no case was tried";
    private bool _isEmpty = true;

    /// <summary>Notes a case.</summary>
    /// <param name="error">How wrong; NaN is the maximum.</param>
    /// <param name="input">Tells the input, complete, in round-trip numbers; asked only if it is the worst so far.</param>
    public void Note(double error, Func<string> input)
    {
        if (_isEmpty || (!double.IsNaN(_error) && !(error <= _error)))
        {
            _error = error;
            _input = input();
            _isEmpty = false;
        }
    }

    /// <summary>Notes the worst of another part of the cases; of two equal ones the first stays.</summary>
    public void Add(WorstCase other)
    {
        if (!other._isEmpty)
        {
            Note(other._error, () => other._input);
        }
    }

    /// <summary>The figure for the report; NaN, which keeps no limit, if nothing was tried.</summary>
    public StressFigure ToFigure(string quantity, string unit, double? limit) => new(quantity, unit, _error, limit, _input);
}
