namespace Msisf.Stress.Metadata;

/// <summary>The errors of an angle: against what is promised wherever the bound allows no more, and against the bound everywhere.</summary>
/// <param name="quantity">Which angle.</param>
/// <param name="promised">degrees.</param>
/// <param name="series">Errors over what makes them grow.</param>
internal sealed class AngleMeasure(string quantity, double promised, SeriesBuilder series)
{
    private readonly WorstCase _plain = new();
    private readonly WorstCase _ratio = new();
    private long _plainCases;
    private long _cases;

    /// <summary>The worst, and how many of the cases the promise is for.</summary>
    public IEnumerable<StressFigure> Figures =>
    [
        _plain.ToFigure(quantity, "degrees", promised),
        _ratio.ToFigure($"{quantity}, to what its bound allows, everywhere", "1", 1.0),
        new StressFigure(
            $"{quantity}, cases that are held to {promised:R} degrees",
            "1",
            (double)_plainCases / _cases,
            null,
            $"{_plainCases} of {_cases}"),
    ];

    /// <summary>The series.</summary>
    public SeriesBuilder Series => series;

    /// <summary>Notes a case.</summary>
    /// <param name="error">degrees.</param>
    /// <param name="bound">degrees.</param>
    /// <param name="input">For the series; null keeps it out.</param>
    /// <param name="text">Tells the input.</param>
    public void Note(double error, double bound, double? input, Func<string> text)
    {
        _cases++;
        _ratio.Note(error / bound, text);
        if (bound <= promised)
        {
            _plainCases++;
            _plain.Note(error, text);
        }

        if (input is double place)
        {
            series.Add(place, error);
        }
    }

    /// <summary>Notes the cases of another.</summary>
    public void Add(AngleMeasure other)
    {
        _plain.Add(other._plain);
        _ratio.Add(other._ratio);
        series.Add(other.Series);
        _plainCases += other._plainCases;
        _cases += other._cases;
    }
}
