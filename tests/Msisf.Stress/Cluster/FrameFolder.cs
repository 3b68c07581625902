using System.Security.Cryptography;

namespace Msisf.Stress.Cluster;

/// <summary>A folder of outputs, looked at from outside.</summary>
internal sealed class FrameFolder
{
    private const string ManifestName = "msisf-manifest.jsonl";

    /// <summary>Files of locks stay, empty: whoever removed one would take it from under another process.</summary>
    private static readonly string[] Stays = [".msisf-manifest.lock", ".msisf-claims"];

    /// <summary>Looks at a folder, which may be missing yet.</summary>
    public FrameFolder(string path) => Path = path;

    /// <summary>Where it is.</summary>
    public string Path { get; }

    /// <summary>The manifest.</summary>
    public byte[] Manifest => File.ReadAllBytes(ManifestPath);

    /// <summary>Lines of the manifest that say that a frame was made.</summary>
    public int FramesMade => File.Exists(ManifestPath)
        ? File.ReadLines(ManifestPath).Count(line => line.StartsWith("""{"record":"frame",""", StringComparison.Ordinal))
        : 0;

    /// <summary>How many files there are beside the manifest.</summary>
    public int Files => Entries().Count(IsOutput);

    /// <summary>What a killed run may leave but a finished one may not.</summary>
    public IReadOnlyList<string> Leftovers =>
        [.. Entries().Where(entry => IsHidden(entry) && !Stays.Contains(entry) || entry.Contains(".partial", StringComparison.Ordinal))];

    /// <summary>Frames of the same files, and the same bytes, as another folder's, its manifest aside.</summary>
    /// <returns>Names of files that only one has or that differ.</returns>
    public IReadOnlyList<string> DifferencesFrom(FrameFolder other)
    {
        Dictionary<string, string> own = Sums();
        Dictionary<string, string> others = other.Sums();
        return [.. own.Keys.Union(others.Keys).Where(
            name => own.GetValueOrDefault(name) != others.GetValueOrDefault(name)).Order(StringComparer.Ordinal)];
    }

    private string ManifestPath => System.IO.Path.Combine(Path, ManifestName);

    private Dictionary<string, string> Sums() => Entries()
        .Where(IsOutput)
        .ToDictionary(
            entry => entry, entry => Convert.ToHexString(SHA256.HashData(File.ReadAllBytes(System.IO.Path.Combine(Path, entry)))));

    private IEnumerable<string> Entries() => Directory.EnumerateFileSystemEntries(Path).Select(entry => System.IO.Path.GetFileName(entry));

    private static bool IsOutput(string entry) => !IsHidden(entry) && entry != ManifestName;

    private static bool IsHidden(string entry) => entry.StartsWith('.');
}
