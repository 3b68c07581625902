namespace Msisf.Adapters.IO;

/// <summary>How much room a disk has.</summary>
public static class DiskRoom
{
    /// <summary>Bytes that can be written into a folder, which need not be there yet.</summary>
    /// <returns><see cref="long.MaxValue"/> where the system does not tell, as Windows of a folder that another computer shares.</returns>
    /// <exception cref="IOException">The disk can't be read.</exception>
    /// <exception cref="UnauthorizedAccessException">The disk may not be read.</exception>
    public static long Of(string folder)
    {
        string there = Path.GetFullPath(folder);
        while (!Directory.Exists(there) && Path.GetDirectoryName(there) is { } above)
        {
            there = above;
        }

        string disk = OperatingSystem.IsWindows() ? Path.GetPathRoot(there)! : there;
        return disk.StartsWith(@"\\", StringComparison.Ordinal) ? long.MaxValue : new DriveInfo(disk).AvailableFreeSpace;
    }
}
