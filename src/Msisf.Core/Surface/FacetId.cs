namespace Msisf.Core.Surface;

/// <summary>
/// Identifies one facet of the surface, of a model of the whole Moon the one that the pattern files draw (docs/pattern-format.md).
/// </summary>
/// <param name="Line">
/// Line of the cell's northern samples, 0 for the northernmost; -1 is the fan around the north pole and 180 res - 1 the fan around the
/// south pole.
/// </param>
/// <param name="Sample">
/// Column of the cell's western samples, 0 to 360 res - 1; those of a map across the prime meridian count on there.
/// </param>
/// <param name="Half">Which of the cell's two facets.</param>
public readonly record struct FacetId(int Line, int Sample, FacetHalf Half)
{
    /// <summary>
    /// The model, from 0 for the coarsest; always 0 in a scene of one. The number of models stands for the seams between them, whose facets
    /// have line 0, their number as sample, and the south-western half.
    /// </summary>
    public int Part { get; init; }
}

/// <summary>Which of the two facets of a cell; the diagonal between them runs from north-west to south-east.</summary>
public enum FacetHalf
{
    /// <summary>(NW, SW, SE); the one facet of a cell of the northern fan.</summary>
    SouthWest,

    /// <summary>(NW, SE, NE); the one facet of a cell of the southern fan.</summary>
    NorthEast,
}

/// <summary>Where the heights of a facet come from.</summary>
public enum FacetSource
{
    /// <summary>From one model, as they are there.</summary>
    Measured = 1,

    /// <summary>From one model, changed to meet others.</summary>
    Blended = 2,

    /// <summary>It joins two models.</summary>
    Seam = 3,

    /// <summary>They are invented.</summary>
    Invented = 4,
}
