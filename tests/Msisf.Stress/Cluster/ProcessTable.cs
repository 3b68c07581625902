using System.Diagnostics;
using System.Globalization;
using Msisf.Core.Errors;

namespace Msisf.Stress.Cluster;

/// <summary>
/// The processes of this machine, as Linux shows them under /proc. Those of other users show neither environment nor folder and are in no
/// answer.
/// </summary>
internal static class ProcessTable
{
    private const string Root = "/proc";

    /// <summary>A process that waits for a disk stops when it has its answer.</summary>
    private static readonly TimeSpan LongestStop = TimeSpan.FromSeconds(10);

    /// <summary>Processes that were started with an entry of their environment, e.g. "NAME=value".</summary>
    public static IReadOnlyList<int> WithEnvironment(string entry) =>
        [.. All().Where(id => Environment(id).Contains(entry, StringComparer.Ordinal))];

    /// <summary>Processes that work in a folder or below it.</summary>
    public static IReadOnlyList<int> Below(string folder) =>
        [.. All().Where(
            id => Target(PathOf(id, "cwd")) is string path
                && (path == folder || path.StartsWith(folder + Path.DirectorySeparatorChar, StringComparison.Ordinal)))];

    /// <summary>Processes of a program that hold a file open.</summary>
    /// <param name="name">Name of the program, its first 15 characters.</param>
    /// <param name="file">Path of the file.</param>
    public static IReadOnlyList<int> Holding(string name, string file) =>
        [.. All().Where(id => NameOf(id) == name && OpenFiles(id).Contains(file))];

    /// <summary>What a process has started and what is still a child of it.</summary>
    /// <param name="parent">Its id.</param>
    /// <param name="name">Name of the child's program, its first 15 characters.</param>
    public static IReadOnlyList<int> ChildrenOf(int parent, string name) =>
        [.. All().Where(id => Field(id, "PPid:") == parent.ToString(CultureInfo.InvariantCulture) && Field(id, "Name:") == name)];

    /// <summary>Name of a process's program, its first 15 characters; null if it has ended.</summary>
    public static string? NameOf(int id) => Field(id, "Name:");

    /// <summary>Resident memory of a process in bytes; null if it has ended.</summary>
    public static long? MemoryOf(int id) =>
        Field(id, "VmRSS:") is string kilobytes ? 1024 * long.Parse(kilobytes, CultureInfo.InvariantCulture) : null;

    /// <summary>Ends a process that is at work: it is stopped first, so that one that ends by itself at this moment does not count.</summary>
    /// <returns>Whether it was at work.</returns>
    public static bool KillAtWork(int id)
    {
        using (Process stop = Process.Start("kill", ["-STOP", id.ToString(CultureInfo.InvariantCulture)]))
        {
            stop.WaitForExit(LongestStop);
        }

        return IsStopped(id) && Kill(id);
    }

    /// <summary>Ends a process as the system does when memory runs out: SIGKILL, which it can't catch.</summary>
    /// <returns>Whether it was there.</returns>
    public static bool Kill(int id)
    {
        try
        {
            using Process process = Process.GetProcessById(id);
            process.Kill();
            return true;
        }
        catch (Exception exception) when (exception is ArgumentException or InvalidOperationException)
        {
            return false;
        }
    }

    /// <summary>Arguments that a process was started with; empty if it has ended.</summary>
    public static string[] ArgumentsOf(int id) => Read(id, "cmdline")?.Split('\0') ?? [];

    /// <summary>Whether it has stopped; one that is ending never will.</summary>
    private static bool IsStopped(int id)
    {
        Stopwatch watch = Stopwatch.StartNew();
        string? state = Field(id, "State:");
        while (state is "R" or "S" or "D" && watch.Elapsed < LongestStop)
        {
            Thread.Sleep(1);
            state = Field(id, "State:");
        }

        return state == "T";
    }

    private static IEnumerable<int> All() => Directory.EnumerateDirectories(Root)
        .Select(folder => int.TryParse(Path.GetFileName(folder), NumberStyles.None, CultureInfo.InvariantCulture, out int id) ? id : 0)
        .Where(id => id > 0);

    private static string[] Environment(int id) => Read(id, "environ")?.Split('\0') ?? [];

    private static string? Field(int id, string name) => Read(id, "status")?
        .Split('\n')
        .FirstOrDefault(line => line.StartsWith(name, StringComparison.Ordinal))?
        .Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries)
        .ElementAtOrDefault(1);

    private static string?[] OpenFiles(int id)
    {
        try
        {
            return [.. Directory.EnumerateFileSystemEntries(PathOf(id, "fd")).Select(Target)];
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return []; // it has ended, or is another user's
        }
    }

    private static string? Target(string link)
    {
        try
        {
            return File.ResolveLinkTarget(link, returnFinalTarget: false)?.FullName;
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return null; // it has ended, or is another user's
        }
    }

    private static string? Read(int id, string file)
    {
        try
        {
            return File.ReadAllText(PathOf(id, file));
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return null; // it has ended, or is another user's
        }
    }

    private static string PathOf(int id, string file) => Path.Combine(Root, id.ToString(CultureInfo.InvariantCulture), file);
}
