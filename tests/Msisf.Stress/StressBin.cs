namespace Msisf.Stress;

/// <summary>The errors of the inputs of one interval.</summary>
/// <param name="From">Least input.</param>
/// <param name="To">Greatest input.</param>
/// <param name="Count">Cases.</param>
/// <param name="Mean">Mean error.</param>
/// <param name="Worst">Greatest error.</param>
public readonly record struct StressBin(double From, double To, long Count, double Mean, double Worst);
