namespace Msisf.Benchmarks.Definitions;

/// <summary>A measured figure: a line of the CSV file.</summary>
/// <param name="Scene">The scene's name.</param>
/// <param name="Quantity">What, e.g. "first" or "further".</param>
/// <param name="Setting">How, e.g. "1 thread, 256 bits"; empty if there is but one way.</param>
/// <param name="Unit">s, bytes, 1, ...</param>
/// <param name="Values">The measurements.</param>
internal sealed record Figure(string Scene, string Quantity, string Setting, string Unit, Samples Values);
