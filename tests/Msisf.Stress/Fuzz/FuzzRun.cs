namespace Msisf.Stress.Fuzz;

/// <summary>What came of a case.</summary>
/// <param name="ExitCode">Null if an exception escaped.</param>
/// <param name="WasToldToEnd">It took so long that it was cancelled.</param>
/// <param name="Output">Standard output.</param>
/// <param name="Error">Standard error.</param>
/// <param name="Time">How long it took.</param>
internal sealed record FuzzRun(int? ExitCode, bool WasToldToEnd, string Output, string Error, TimeSpan Time);
