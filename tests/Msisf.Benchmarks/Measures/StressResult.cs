namespace Msisf.Benchmarks.Measures;

/// <summary>A run of all stress tests.</summary>
/// <param name="Machine">What they ran on.</param>
/// <param name="Tests">In the order of the list.</param>
internal sealed record StressResult(string Machine, IReadOnlyList<StressTestResult> Tests);
