namespace Msisf.Adapters.Ephemeris;

/// <summary>The values of one name in text kernels: all numbers or all texts.</summary>
/// <param name="Numbers">
/// Empty if the values are texts. Dates (@1972-JAN-1) count as seconds past 2000-01-01T12:00:00, each day with 86 400 s.
/// </param>
/// <param name="Texts">Empty if the values are numbers.</param>
/// <param name="Source">The file and line that assigned last, for messages.</param>
public sealed record KernelVariable(IReadOnlyList<double> Numbers, IReadOnlyList<string> Texts, string Source);
