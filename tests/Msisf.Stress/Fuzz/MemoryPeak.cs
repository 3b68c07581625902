using System.Globalization;

namespace Msisf.Stress.Fuzz;

/// <summary>The most memory that this process had since the last reset, as Linux counts it; elsewhere what it has now.</summary>
internal static class MemoryPeak
{
    private const string Status = "/proc/self/status";
    private const string ResetFile = "/proc/self/clear_refs";
    private const string Field = "VmHWM:";

    /// <summary>Starts anew from what the process has now.</summary>
    public static void Reset()
    {
        if (File.Exists(ResetFile))
        {
            File.WriteAllText(ResetFile, "5"); // proc(5): resets the peak
        }
    }

    /// <summary>Bytes.</summary>
    public static long Read() => File.Exists(Status)
        ? 1024 * long.Parse(
            File.ReadLines(Status).First(
                line =>
                    line.StartsWith(Field, StringComparison.Ordinal))[Field.Length..].Replace("kB", "", StringComparison.Ordinal).Trim(),
            CultureInfo.InvariantCulture)
        : Environment.WorkingSet;
}
