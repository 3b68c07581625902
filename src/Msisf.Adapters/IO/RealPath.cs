namespace Msisf.Adapters.IO;

/// <summary>Finds the one name of a file or folder that symbolic links give several.</summary>
internal static class RealPath
{
    /// <summary>Links that lead to links, as many as Linux follows.</summary>
    private const int MostLinks = 40;

    /// <summary>The full path with the links of all its folders followed; what is not there yet keeps its name.</summary>
    public static string Of(string path)
    {
        int links = 0;
        return Follow(Path.GetFullPath(path));

        string Follow(string full)
        {
            if (Path.GetDirectoryName(full) is not { } folder)
            {
                return full;
            }

            string here = Path.Combine(Follow(folder), Path.GetFileName(full));
            return TargetOf(here) is { } target && ++links <= MostLinks
                ? Follow(Path.GetFullPath(target, Path.GetDirectoryName(here)!))
                : here;
        }
    }

    private static string? TargetOf(string path)
    {
        try
        {
            return new FileInfo(path).LinkTarget;
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return null; // a folder that can't be read
        }
    }
}
