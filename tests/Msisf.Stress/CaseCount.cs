namespace Msisf.Stress;

/// <summary>
/// How many cases did what none may do, and the first of them. Not safe for several threads: each has its own, merged by <see cref="Add"/>.
/// </summary>
public sealed class CaseCount
{
    private long _tried;
    private long _wrong;
    private string _first = string.Empty;

    /// <summary>Notes a case.</summary>
    /// <param name="isWrong">Whether it did what it may not.</param>
    /// <param name="input">Tells the input, complete, in round-trip numbers; asked for the first wrong one only.</param>
    public void Note(bool isWrong, Func<string> input) => Note(isWrong ? 1 : 0, 1, input);

    /// <summary>Notes several cases of one input.</summary>
    /// <param name="wrong">How many did what they may not.</param>
    /// <param name="tried">How many in all.</param>
    /// <param name="input">As above.</param>
    public void Note(long wrong, long tried, Func<string> input)
    {
        _first = _wrong == 0 && wrong > 0 ? input() : _first;
        _wrong += wrong;
        _tried += tried;
    }

    /// <summary>Notes the cases of a later part.</summary>
    public void Add(CaseCount other) => Note(other._wrong, other._tried, () => other._first);

    /// <summary>The figure for the report; NaN, which keeps no limit, if nothing was tried.</summary>
    public StressFigure ToFigure(string quantity, string unit, double? limit) =>
        new(
            quantity,
            unit,
            _tried == 0 ? double.NaN : _wrong,
            limit,
            _wrong == 0 ? FormattableString.Invariant($"none of {_tried}") : _first);
}
