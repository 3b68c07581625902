namespace Msisf.Stress;

/// <summary>What a stress test found.</summary>
/// <param name="Name">Of the test.</param>
/// <param name="Cases">Inputs that were tried.</param>
/// <param name="Figures">The worst of each quantity.</param>
/// <param name="Series">Errors over the range of an input.</param>
public sealed record StressReport(string Name, long Cases, IReadOnlyList<StressFigure> Figures, IReadOnlyList<StressSeries> Series);
