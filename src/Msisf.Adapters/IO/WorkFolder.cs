using System.Globalization;
using Msisf.Core.Errors;

namespace Msisf.Adapters.IO;

/// <summary>
/// A folder for one job's own files, beside the outputs, removed at the end. While it is in use a file in it is locked; the system
/// frees the lock of a process that was killed, so that a later run can tell its remains from the folder of one that works.
/// </summary>
public sealed class WorkFolder : IDisposable
{
    private const string Prefix = ".msis-";
    private const string LockName = "lock";

    private readonly FileStream _heldLock;

    private WorkFolder(string path)
    {
        Path = path;
        Directory.CreateDirectory(path);
        _heldLock = OpenLock(path);
    }

    /// <summary>The folder.</summary>
    public string Path { get; }

    /// <summary>Makes a folder.</summary>
    /// <param name="parent">Existing folder on the disk of the outputs.</param>
    /// <exception cref="IOException">The file system refuses.</exception>
    /// <exception cref="UnauthorizedAccessException">The file system refuses.</exception>
    public static WorkFolder In(string parent) => new(System.IO.Path.Combine(
        parent, string.Create(CultureInfo.InvariantCulture, $"{Prefix}{Environment.ProcessId}-{Guid.NewGuid():N}")));

    /// <summary>Removes the folders that killed processes left.</summary>
    /// <param name="parent">Existing folder of outputs.</param>
    /// <returns>How many were removed; those that can't be removed stay.</returns>
    public static int RemoveStale(string parent)
    {
        int removed = 0;
        foreach (string folder in Directory.EnumerateDirectories(parent, Prefix + "*"))
        {
            try
            {
                // A folder without the file is just being made.
                if (File.Exists(System.IO.Path.Combine(folder, LockName)))
                {
                    using (OpenLock(folder))
                    {
                        Directory.Delete(folder, recursive: true);
                    }

                    removed++;
                }
            }
            catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
            {
                continue; // in use, or another user's
            }
        }

        return removed;
    }

    /// <summary>Removes the folder with all that is in it.</summary>
    /// <exception cref="ExternalPartException">The file system refuses.</exception>
    public void Dispose()
    {
        try
        {
            if (Directory.Exists(Path))
            {
                Directory.Delete(Path, recursive: true);
            }
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            throw new ExternalPartException($"{Path}: can't be removed: {exception.Message}", exception);
        }
        finally
        {
            _heldLock.Dispose();
        }
    }

    private static FileStream OpenLock(string folder) =>
        new(System.IO.Path.Combine(folder, LockName), FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None);
}
