using System.Collections.Concurrent;
using Msisf.Adapters.Metadata;
using Msisf.App.Host;
using Msisf.Core.Metadata;

namespace Msisf.App.Series;

/// <summary>
/// Compares the input files that existing meta files name with those of the run, and warns once about each difference. Thread-safe.
/// </summary>
internal sealed class InputComparison(ILog log)
{
    /// <summary>Digits of a checksum that a message shows: enough to tell two apart.</summary>
    private const int ShownDigits = 12;

    private readonly ConcurrentDictionary<string, bool> _seen = new();

    /// <summary>Compares an existing meta file with the run.</summary>
    /// <param name="metaFile">Path of the meta file; it may be missing, or older than its format's version 3.</param>
    public void Compare(string metaFile, IReadOnlyList<InputFile> now)
    {
        IReadOnlyList<InputFile> made = MetaFileOrigin.Inputs(metaFile);
        string differences = made.Count == 0 ? string.Empty : string.Join("; ", Differences(made, now));
        if (differences.Length > 0 && _seen.TryAdd(differences, true))
        {
            log.Warning($"{Path.GetFileName(metaFile)} was made from other input files: {differences}.");
        }
    }

    private static IEnumerable<string> Differences(IReadOnlyList<InputFile> made, IReadOnlyList<InputFile> now)
    {
        InputFile[] others = [.. made.Except(now)];
        InputFile[] mine = [.. now.Except(made)];
        foreach (InputFile other in others)
        {
            InputFile? same = Array.Find(mine, file => (file.Kind, file.Name) == (other.Kind, other.Name));
            yield return same is null
                ? $"{other.Name}, which this run does not use"
                : $"another {other.Name} (SHA-256 {other.Sha256[..Math.Min(ShownDigits, other.Sha256.Length)]}..., "
                    + $"now {same.Sha256[..ShownDigits]}...)";
        }

        foreach (InputFile added in mine.Where(file => !others.Any(other => (other.Kind, other.Name) == (file.Kind, file.Name))))
        {
            yield return $"without {added.Name}";
        }
    }
}
