using System.Globalization;
using Msisf.Core.Errors;

namespace Msisf.Benchmarks.Programs;

/// <summary>The most memory that any child of a process held. Linux only; elsewhere it stays 0.</summary>
internal sealed class ChildrenMemory
{
    private const string Processes = "/proc";

    private readonly string _parent;
    private string? _child;

    /// <summary>Watches the children of a process.</summary>
    /// <param name="parentId">Its id.</param>
    public ChildrenMemory(int parentId) => _parent = parentId.ToString(CultureInfo.InvariantCulture);

    /// <summary>Bytes resident at once, as the system recorded it up to the last look.</summary>
    public long PeakBytes { get; private set; }

    /// <summary>Looks. All processes are gone through only until a child is found.</summary>
    public void Look()
    {
        if (!Directory.Exists(Processes))
        {
            return;
        }

        if (_child is null || !TryReadPeak(_child))
        {
            _child = Directory.EnumerateDirectories(Processes).FirstOrDefault(
                folder => char.IsAsciiDigit(Path.GetFileName(folder)[0]) && IsChild(folder));
        }
    }

    private bool TryReadPeak(string folder)
    {
        if (StatusField(folder, "VmHWM:") is not string kilobytes)
        {
            return false;
        }

        PeakBytes = Math.Max(PeakBytes, 1024 * long.Parse(kilobytes, CultureInfo.InvariantCulture));
        return true;
    }

    private bool IsChild(string folder) => StatusField(folder, "PPid:") == _parent;

    /// <summary>Null if the process has ended, or is about to.</summary>
    private static string? StatusField(string folder, string name)
    {
        try
        {
            return File.ReadLines(Path.Combine(folder, "status"))
                .FirstOrDefault(line => line.StartsWith(name, StringComparison.Ordinal))?
                .Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries)[1];
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return null;
        }
    }
}
