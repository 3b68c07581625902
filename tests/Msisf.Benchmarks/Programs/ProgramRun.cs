namespace Msisf.Benchmarks.Programs;

/// <summary>A run of a program that ended well.</summary>
/// <param name="Seconds">From just before the start of the process to its end.</param>
/// <param name="Output">Lines of standard output, each with the seconds since the start.</param>
/// <param name="Errors">Lines of standard error.</param>
/// <param name="Memory">Resident memory while it ran; empty if it was not watched.</param>
/// <param name="ChildrenPeakBytes">Most that a program that it started held; 0 if it was not watched or started none.</param>
internal sealed record ProgramRun(
    double Seconds,
    IReadOnlyList<(double Seconds, string Line)> Output,
    IReadOnlyList<string> Errors,
    IReadOnlyList<MemorySample> Memory,
    long ChildrenPeakBytes);
