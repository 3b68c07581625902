using Msisf.Stress;

namespace Msisf.Benchmarks.Measures;

/// <summary>A run of all stress tests.</summary>
/// <param name="Machine">What they ran on.</param>
/// <param name="Tests">In the order of the list.</param>
internal sealed record StressResult(string Machine, IReadOnlyList<StressTestResult> Tests);

/// <summary>What came of a stress test.</summary>
/// <param name="Test">Which.</param>
/// <param name="Report">What it found; null if a part was missing that it can't run without.</param>
/// <param name="Seconds">How long it took.</param>
internal sealed record StressTestResult(IStressTest Test, StressReport? Report, double Seconds);
