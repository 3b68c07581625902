namespace Msisf.Stress;

/// <summary>The greatest error so far and the input that shows it. Not safe for several threads: each has its own, merged by <see cref="Add"/>.</summary>
public sealed class WorstCase
{
    private string _input = "no case was tried";

    /// <summary>The greatest error; NaN if one was met or none was tried.</summary>
    public double Error { get; private set; } = double.NaN;

    private bool IsEmpty { get; set; } = true;

    /// <summary>Whether an error is greater; asked before its input is written out, which takes longer than most cases. NaN is the greatest.</summary>
    public bool IsBeatenBy(double error) => IsEmpty || (!double.IsNaN(Error) && !(error <= Error));

    /// <summary>Takes an error that <see cref="IsBeatenBy"/> has let through.</summary>
    /// <param name="error">How wrong.</param>
    /// <param name="input">Complete, in round-trip numbers.</param>
    public void Take(double error, string input)
    {
        Error = error;
        _input = input;
        IsEmpty = false;
    }

    /// <summary>Notes a case.</summary>
    /// <param name="error">How wrong.</param>
    /// <param name="input">Tells the input, complete, in round-trip numbers; asked only if it is the worst so far.</param>
    public void Note(double error, Func<string> input)
    {
        if (IsBeatenBy(error))
        {
            Take(error, input());
        }
    }

    /// <summary>Notes the worst of another part of the cases; of two equal ones the first stays.</summary>
    public void Add(WorstCase other)
    {
        if (!other.IsEmpty && IsBeatenBy(other.Error))
        {
            Take(other.Error, other._input);
        }
    }

    /// <summary>The figure for the report.</summary>
    public StressFigure ToFigure(string quantity, string unit, double? limit) => new(quantity, unit, Error, limit, _input);
}
