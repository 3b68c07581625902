using System.Diagnostics;
using System.Globalization;

namespace Msisf.Benchmarks.Programs;

/// <summary>Resident memory of a process at a moment.</summary>
/// <param name="Seconds">Since its start.</param>
/// <param name="OwnBytes">What it has allocated; where the system does not tell the two apart, all.</param>
/// <param name="FileBytes">Pages of mapped files: the system takes them back when it likes.</param>
internal readonly record struct MemorySample(double Seconds, long OwnBytes, long FileBytes)
{
    /// <summary>Looks at a process.</summary>
    /// <param name="process">It may have ended.</param>
    /// <param name="seconds">Since its start.</param>
    /// <returns>Null if it has ended.</returns>
    public static MemorySample? Of(Process process, double seconds)
    {
        string status = string.Create(CultureInfo.InvariantCulture, $"/proc/{process.Id}/status");
        try
        {
            if (!OperatingSystem.IsLinux())
            {
                process.Refresh();
                return new MemorySample(seconds, process.WorkingSet64, 0);
            }

            string[] lines = File.ReadAllLines(status);
            return Field(lines, "RssAnon:") is long own && Field(lines, "RssFile:") is long file
                ? new MemorySample(seconds, own, file)
                : null;
        }
        catch (Exception exception) when (exception is IOException or InvalidOperationException)
        {
            return null;
        }
    }

    /// <summary>"RssAnon:     1234 kB" in bytes; a process that is about to be gone has no such line.</summary>
    private static long? Field(string[] lines, string name) =>
        Array.Find(lines, line => line.StartsWith(name, StringComparison.Ordinal)) is string line
            ? 1024 * long.Parse(line.Split(' ', StringSplitOptions.RemoveEmptyEntries)[1], CultureInfo.InvariantCulture)
            : null;
}
