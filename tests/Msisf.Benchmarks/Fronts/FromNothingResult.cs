namespace Msisf.Benchmarks.Fronts;

/// <summary>What the first image costs whose model nobody has prepared.</summary>
/// <param name="About">Which image, in words.</param>
/// <param name="Seconds">From the start of the process to its end.</param>
/// <param name="PeakMemoryBytes">Of msis.</param>
internal sealed record FromNothingResult(string About, double Seconds, double PeakMemoryBytes);
