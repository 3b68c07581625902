namespace Msisf.Stress.Fuzz;

/// <summary>A right file and how it is read.</summary>
/// <param name="FileName">Its name in the case's folder.</param>
/// <param name="Prepare">Puts what lies beside it into the folder, and gives its right content.</param>
/// <param name="Calls">The calls that read it, by its path; one is taken.</param>
internal sealed record FuzzInput(string FileName, Func<string, byte[]> Prepare, Func<string, IEnumerable<IReadOnlyList<string>>> Calls)
{
    /// <summary>A copy of a file, with all others of its folder beside it.</summary>
    /// <param name="path">The right file.</param>
    /// <param name="calls">As above.</param>
    /// <param name="place">Puts one of the others there; links are enough for most.</param>
    public static FuzzInput Among(
        string path, Func<string, IEnumerable<IReadOnlyList<string>>> calls, Action<string, string>? place = null) => new(
        Path.GetFileName(path),
        folder =>
        {
            foreach (string other in Directory.EnumerateFiles(Path.GetDirectoryName(path)!).Where(other => other != path))
            {
                (place ?? Link)(other, Path.Combine(folder, Path.GetFileName(other)));
            }

            return File.ReadAllBytes(path);
        },
        calls);

    /// <summary>A text that stands alone.</summary>
    public static FuzzInput Text(string fileName, string text, Func<string, IEnumerable<IReadOnlyList<string>>> calls) =>
        new(fileName, _ => System.Text.Encoding.UTF8.GetBytes(text), calls);

    private static void Link(string path, string link) => File.CreateSymbolicLink(link, path);
}
