namespace Msisf.Adapters.Raster;

/// <summary>
/// Finds files whose names differ in upper and lower case: archives write names in capitals, downloads often do not keep them.
/// </summary>
internal static class FileNames
{
    private static readonly EnumerationOptions IgnoringCase =
        new() { MatchCasing = MatchCasing.CaseInsensitive, MatchType = MatchType.Simple };

    /// <summary>The file of this path, or the first one whose name differs in case only; null if there is none.</summary>
    public static string? FindIgnoringCase(string path)
    {
        if (File.Exists(path))
        {
            return path;
        }

        string folder = FolderOf(path);
        return Directory.Exists(folder)
            ? Directory.EnumerateFiles(folder, Path.GetFileName(path), IgnoringCase).Order(StringComparer.Ordinal).FirstOrDefault()
            : null;
    }

    /// <summary>The label of an image or a label; the image itself if none lies beside it, as its label can be attached.</summary>
    public static string LabelOf(string path) => Path.GetExtension(path).Equals(".IMG", StringComparison.OrdinalIgnoreCase)
        ? FindIgnoringCase(Path.ChangeExtension(path, ".LBL")) ?? path
        : path;

    public static string FolderOf(string path) => Path.GetDirectoryName(path) is { Length: > 0 } folder ? folder : ".";

    /// <summary>Names for a message: all of a few, the first of many.</summary>
    public static string Listed(IEnumerable<string?> names)
    {
        const int Most = 16;
        string?[] all = [.. names];
        return all.Length <= Most
            ? string.Join(", ", all)
            : $"{string.Join(", ", all.Take(Most))} and {all.Length - Most} more";
    }
}
