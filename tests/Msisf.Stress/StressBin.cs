namespace Msisf.Stress;

/// <summary>The errors of the inputs of one interval.</summary>
/// <param name="From">Minimum input.</param>
/// <param name="To">Maximum input.</param>
/// <param name="Count">Cases.</param>
/// <param name="Mean">Mean error.</param>
/// <param name="Worst">Maximum error.</param>
public readonly record struct StressBin(double From, double To, long Count, double Mean, double Worst);
