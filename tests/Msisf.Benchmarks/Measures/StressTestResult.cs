using Msisf.Stress;

namespace Msisf.Benchmarks.Measures;

/// <summary>What came of a stress test.</summary>
/// <param name="Test">Which.</param>
/// <param name="Report">What it found; null if a part was missing that it can't run without.</param>
/// <param name="Seconds">How long it took.</param>
internal sealed record StressTestResult(IStressTest Test, StressReport? Report, double Seconds);
