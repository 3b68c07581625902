namespace Msisf.Stress;

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
