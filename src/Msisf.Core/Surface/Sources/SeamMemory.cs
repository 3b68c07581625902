using System.Collections.Concurrent;

namespace Msisf.Core.Surface.Sources;

/// <summary>Keeps fillings of gaps in memory, and those that are worth it in another store too. Safe for several threads.</summary>
/// <param name="files">The other store; null for none.</param>
/// <param name="minFacets">Facets of a filling that the other store gets: fewer are found again as fast as read.</param>
public sealed class SeamMemory(ISeamStore? files = null, int minFacets = SeamMemory.DefaultMinFacets) : ISeamStore
{
    /// <summary>Finding so many facets takes some 0.1 s.</summary>
    public const int DefaultMinFacets = 8192;

    /// <summary>Corners that are kept, 64 MB; beyond that all are dropped.</summary>
    private const int MaxCorners = 1 << 24;

    private readonly ConcurrentDictionary<string, GapTriangulation> _known = new(StringComparer.Ordinal);
    private long _corners;

    /// <inheritdoc/>
    public GapTriangulation? Find(string productId, string border)
    {
        if (!_known.TryGetValue(border, out GapTriangulation? filling) && files?.Find(productId, border) is { } stored)
        {
            filling = stored;
            Remember(stored);
        }

        return filling;
    }

    /// <inheritdoc/>
    public void Keep(GapTriangulation filling)
    {
        Remember(filling);
        if (filling.Corners.Length >= 3 * minFacets)
        {
            files?.Keep(filling);
        }
    }

    private void Remember(GapTriangulation filling)
    {
        if (Interlocked.Add(ref _corners, filling.Corners.Length) > MaxCorners)
        {
            _known.Clear();
            Interlocked.Exchange(ref _corners, filling.Corners.Length);
        }

        _known[filling.Key] = filling;
    }
}
