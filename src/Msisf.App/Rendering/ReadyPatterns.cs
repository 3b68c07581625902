using System.Collections.Concurrent;
using Msisf.Adapters.Tiles;

namespace Msisf.App.Rendering;

/// <summary>The patterns of a run, each checked or made once per run. Thread-safe.</summary>
/// <typeparam name="T">Names a pattern.</typeparam>
internal sealed class ReadyPatterns<T>
    where T : struct
{
    private readonly ConcurrentDictionary<T, bool> _ready = new();

    /// <summary>Number of patterns that were checked or made.</summary>
    public int Count => _ready.Count;

    /// <summary>Makes the patterns that are missing.</summary>
    /// <param name="ensure">Checks or makes those that were not asked for before.</param>
    /// <returns>Number of patterns that were made.</returns>
    public int Ensure(IEnumerable<T> wanted, Func<T[], PatternSet> ensure)
    {
        T[] unknown = [.. wanted.Where(pattern => !_ready.ContainsKey(pattern))];
        if (unknown.Length == 0)
        {
            return 0;
        }

        PatternSet set = ensure(unknown);
        foreach (T pattern in unknown)
        {
            _ready[pattern] = true;
        }

        return set.Written;
    }
}
