namespace Msisf.Stress;

/// <summary>How many cases did what none may do, and the first of them. Not safe for several threads: each has its own, merged by <see cref="Add(CaseCount)"/>.</summary>
public sealed class CaseCount
{
    private long _tried;
    private long _wrong;
    private string _first = string.Empty;

    /// <summary>Notes a case.</summary>
    /// <param name="isWrong">Whether it did what it may not.</param>
    /// <param name="input">Complete, in round-trip numbers; asked for the first wrong one only.</param>
    public void Add(bool isWrong, Func<string> input)
    {
        _tried++;
        if (isWrong && _wrong++ == 0)
        {
            _first = input();
        }
    }

    /// <summary>Notes the cases of a later part.</summary>
    public void Add(CaseCount other)
    {
        _first = _wrong == 0 ? other._first : _first;
        _tried += other._tried;
        _wrong += other._wrong;
    }

    /// <summary>The figure for the report; NaN, which keeps no limit, if nothing was tried.</summary>
    public StressFigure ToFigure(string quantity, string unit, double? limit) =>
        new(quantity, unit, _tried == 0 ? double.NaN : _wrong, limit, _wrong == 0 ? FormattableString.Invariant($"none of {_tried}") : _first);
}
