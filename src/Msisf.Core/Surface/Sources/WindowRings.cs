namespace Msisf.Core.Surface.Sources;

/// <summary>
/// Keeps the facets between windows, of which those of frames near each other are mostly the same. For one thread at a time.
/// </summary>
internal sealed class WindowRings
{
    /// <summary>Rings that are kept: some more than a view has.</summary>
    private const int KeptRings = 48;

    private readonly LinkedList<(Ring Key, IReadOnlyList<SeamVertex> Corners)> _known = [];

    /// <summary>Three corners of each facet between a window and the one inside it (<see cref="WindowSeam"/>).</summary>
    /// <param name="ring">Where they lie, and their parts.</param>
    /// <param name="fill">Makes the facets.</param>
    public IReadOnlyList<SeamVertex> Get(Ring ring, Func<IReadOnlyList<SeamVertex>> fill)
    {
        var known = _known.FirstOrDefault(kept => kept.Key == ring);
        if (known.Corners is not null)
        {
            _known.Remove(known);
        }
        else
        {
            known = (ring, fill());
        }

        _known.AddFirst(known);
        if (_known.Count > KeptRings)
        {
            _known.RemoveLast();
        }

        return known.Corners;
    }

    /// <summary>A ring between two windows.</summary>
    /// <param name="OuterPart">Part of the outer window; that of the inner one is the next.</param>
    /// <param name="IsOuterBlended">Whether the outer window is the coarsest, whose border is blended.</param>
    internal readonly record struct Ring(WindowPlace Outer, WindowPlace Inner, int OuterPart, bool IsOuterBlended);
}
