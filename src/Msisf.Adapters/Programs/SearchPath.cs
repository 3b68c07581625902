namespace Msisf.Adapters.Programs;

/// <summary>Looks for programs in folders.</summary>
public static class SearchPath
{
    /// <summary>The full path of the first program that is there; null if none is.</summary>
    /// <param name="folders">In the form of the PATH variable; a folder earlier in it goes before.</param>
    /// <param name="names">File names under which the program may be installed; the first goes before the others in each folder.</param>
    public static string? Find(string folders, params string[] names) =>
        (from folder in folders.Split(Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries)
         from name in names
         let candidate = Path.Combine(folder, name)
         where File.Exists(candidate)
         select Path.GetFullPath(candidate)).FirstOrDefault();
}
