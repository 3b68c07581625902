namespace Msisf.Adapters.IO;

/// <summary>
/// A temporary folder for one job, beside the outputs. A file in it is locked while it is in use. The system frees the lock of a killed
/// process, so that a later run can tell a folder that was left behind from one in use.
/// </summary>
public sealed class WorkFolder : IDisposable
{
    private const string Prefix = ".msis-";
    private const string LockName = "lock";

    /// <summary>A try fails only if another process looks for remains just when the folder exists and its lock does not.</summary>
    private const int Tries = 100;

    private readonly FileStream _heldLock;

    private WorkFolder(string path, FileStream heldLock) => (Path, _heldLock) = (path, heldLock);

    /// <summary>The folder.</summary>
    public string Path { get; }

    /// <summary>Makes a folder.</summary>
    /// <param name="parent">Existing folder on the disk of the outputs.</param>
    /// <exception cref="IOException">The file system refuses.</exception>
    /// <exception cref="UnauthorizedAccessException">The file system refuses.</exception>
    public static WorkFolder In(string parent)
    {
        for (int left = Tries; ; left--)
        {
            string path = System.IO.Path.Combine(
                parent, Invariant($"{Prefix}{Environment.ProcessId}-{Guid.NewGuid():N}"));
            Directory.CreateDirectory(path);
            if (TryLock(path, isLast: left == 0) is FileStream heldLock)
            {
                return new WorkFolder(path, heldLock);
            }
        }
    }

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
                using (OpenLock(folder))
                {
                    RemoveContents(folder);
                }

                Directory.Delete(folder);
                removed++;
            }
            catch (Exception exception) when (exception.IsFileError())
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
            RemoveContents(Path);
            _heldLock.Dispose();
            int left = Tries;
            while (!TryRemove(isLast: --left == 0))
            {
                Thread.Sleep(1);
            }
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            throw new ExternalPartException($"{Path}: can't be removed: {exception.Message}", exception);
        }
        finally
        {
            _heldLock.Dispose();
        }
    }

    /// <summary>Removes all but the lock, which Windows keeps as long as it is open.</summary>
    private static void RemoveContents(string folder)
    {
        if (!Directory.Exists(folder))
        {
            return;
        }

        foreach (FileSystemInfo entry in new DirectoryInfo(folder).EnumerateFileSystemInfos().Where(entry => entry.Name != LockName))
        {
            if (entry is DirectoryInfo { LinkTarget: null } inner)
            {
                inner.Delete(recursive: true);
            }
            else
            {
                entry.Delete();
            }
        }
    }

    /// <returns>
    /// False if it has to be tried again: another process took the folder for remains as soon as the file of the lock was gone.
    /// </returns>
    private bool TryRemove(bool isLast)
    {
        try
        {
            if (Directory.Exists(Path))
            {
                Directory.Delete(Path, recursive: true);
            }

            return true;
        }
        catch (IOException) when (!isLast)
        {
            return false;
        }
    }

    /// <summary>Locks a folder that was just made.</summary>
    /// <returns>Null if another process took it for remains before it was locked, and has removed it or is about to.</returns>
    private static FileStream? TryLock(string folder, bool isLast)
    {
        try
        {
            FileStream heldLock = OpenLock(folder);
            if (File.Exists(LockOf(folder)))
            {
                return heldLock;
            }

            heldLock.Dispose(); // of a file that was removed between its making and its locking
            return null;
        }
        catch (IOException exception) when (!isLast && (exception is DirectoryNotFoundException || FileLock.IsHeldByAnother(exception)))
        {
            return null;
        }
    }

    /// <summary>The file goes as it is closed, before its lock is free.</summary>
    private static FileStream OpenLock(string folder) => new(
        LockOf(folder), FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None, bufferSize: 1, FileOptions.DeleteOnClose);

    private static string LockOf(string folder) => System.IO.Path.Combine(folder, LockName);
}
