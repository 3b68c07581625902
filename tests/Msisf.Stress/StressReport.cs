namespace Msisf.Stress;

/// <summary>What a stress test found.</summary>
/// <param name="Name">Of the test.</param>
/// <param name="Cases">Inputs that were tried.</param>
/// <param name="Figures">The worst of each quantity.</param>
/// <param name="Series">Errors over the range of an input.</param>
public sealed record StressReport(string Name, long Cases, IReadOnlyList<StressFigure> Figures, IReadOnlyList<StressSeries> Series);

/// <summary>The worst of a quantity.</summary>
/// <param name="Quantity">What, e.g. "residual of Kepler's equation".</param>
/// <param name="Unit">E.g. "ulp"; empty for a count.</param>
/// <param name="Worst">The maximum that was met.</param>
/// <param name="Limit">It may not exceed this; null if it is only reported.</param>
/// <param name="WorstInput">The input that shows it, complete, in round-trip numbers.</param>
public sealed record StressFigure(string Quantity, string Unit, double Worst, double? Limit, string WorstInput)
{
    /// <summary>Whether it keeps its limit; NaN keeps none.</summary>
    public bool IsKept => Limit is not double limit || Worst <= limit;
}

/// <summary>Errors over the range of an input, for a plot.</summary>
/// <param name="Quantity">What is wrong by how much; the plot's vertical axis.</param>
/// <param name="Unit">Of the error.</param>
/// <param name="Input">What varies; the horizontal axis.</param>
/// <param name="InputUnit">Of the input.</param>
/// <param name="IsInputLogarithmic">Whether the bins are equal in the logarithm of the input.</param>
/// <param name="Limit">Drawn as a line; null for none.</param>
/// <param name="Bins">In order of the input; those without a case are left out.</param>
public sealed record StressSeries(
    string Quantity, string Unit, string Input, string InputUnit, bool IsInputLogarithmic, double? Limit, IReadOnlyList<StressBin> Bins);

/// <summary>The errors of the inputs of one interval.</summary>
/// <param name="From">Minimum input.</param>
/// <param name="To">Maximum input.</param>
/// <param name="Count">Cases.</param>
/// <param name="Mean">Mean error.</param>
/// <param name="Worst">Maximum error.</param>
public readonly record struct StressBin(double From, double To, long Count, double Mean, double Worst);
