namespace Msisf.Stress;

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
