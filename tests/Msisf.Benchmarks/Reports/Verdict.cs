namespace Msisf.Benchmarks.Reports;

/// <summary>A target and what was measured.</summary>
/// <param name="Scene">What is measured, in words.</param>
/// <param name="Quantity">Which figure of it.</param>
/// <param name="Limit">The target, SI units.</param>
/// <param name="IsUpperLimit">The figure must be at most the limit; otherwise at least.</param>
/// <param name="Measured">The figure that counts: the median of times, the maximum of memory; NaN if it could not be measured.</param>
/// <param name="Best">The best single value.</param>
/// <param name="Unit">How the three are shown.</param>
internal sealed record Verdict(string Scene, string Quantity, double Limit, bool IsUpperLimit, double Measured, double Best, Unit Unit)
{
    public bool IsMet => IsUpperLimit ? Measured <= Limit : Measured >= Limit;

    public string Word => double.IsNaN(Measured) ? "not measured" : IsMet ? "met" : "missed";
}
