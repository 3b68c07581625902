namespace Msisf.Stress;

/// <summary>Keeps the worst of a quantity and the input that showed it. Not safe for several threads: each has its own, merged by <see cref="Add(FigureBuilder)"/>.</summary>
/// <param name="quantity">What.</param>
/// <param name="unit">Empty for a count.</param>
/// <param name="limit">It may not exceed this; null if it is only reported.</param>
public sealed class FigureBuilder(string quantity, string unit, double? limit)
{
    private double _worst;
    private string _worstInput = string.Empty;

    /// <summary>Notes a case; NaN is worse than any number.</summary>
    /// <param name="value">Not below 0.</param>
    /// <param name="input">Tells the input; asked only if it is the worst so far.</param>
    public void Add(double value, Func<string> input)
    {
        if (!(value <= _worst) && !double.IsNaN(_worst))
        {
            _worst = value;
            _worstInput = input();
        }
    }

    /// <summary>Counts a case that should not be; the first is kept.</summary>
    /// <param name="input">Tells it.</param>
    public void Count(Func<string> input)
    {
        _worstInput = _worst == 0.0 ? input() : _worstInput;
        _worst++;
    }

    /// <summary>Notes the cases of another builder of the same quantity, those of <see cref="Count"/> by their sum.</summary>
    public void Add(FigureBuilder other)
    {
        if (unit.Length > 0)
        {
            Add(other._worst, () => other._worstInput);
            return;
        }

        _worstInput = _worst == 0.0 ? other._worstInput : _worstInput;
        _worst += other._worst;
    }

    /// <summary>The figure so far.</summary>
    public StressFigure ToFigure() => new(quantity, unit, _worst, limit, _worstInput);
}
