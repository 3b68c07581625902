using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Msisf.Benchmarks.Programs;

/// <summary>What the figures depend on besides the program.</summary>
internal static class Machine
{
    private const string ProcessorFile = "/proc/cpuinfo";
    private const string LoadFile = "/proc/loadavg";

    /// <summary>Processor, cores, vectors, runtime, in one sentence.</summary>
    public static string Describe()
    {
        string vectors = Vector512.IsHardwareAccelerated ? "with AVX-512" : "without AVX-512";
        return FormattableString.Invariant(
            $"Measured on {Environment.ProcessorCount} cores, {Processor()}, {vectors}, {RuntimeInformation.FrameworkDescription}.");
    }

    /// <summary>Load of the last minute: how many others wanted the cores.</summary>
    public static string Load() => File.Exists(LoadFile) ? File.ReadAllText(LoadFile).Split(' ')[0] : "unknown";

    private static string Processor()
    {
        string? line = File.Exists(ProcessorFile)
            ? File.ReadLines(ProcessorFile).FirstOrDefault(text => text.StartsWith("model name", StringComparison.Ordinal))
            : null;
        return line is null
            ? RuntimeInformation.ProcessArchitecture.ToString()
            : line[(line.IndexOf(':', StringComparison.Ordinal) + 1)..].Trim();
    }
}
