namespace Msisf.Core.Surface;

/// <summary>Which of the two facets of a cell; the diagonal between them runs from north-west to south-east.</summary>
public enum FacetHalf
{
    /// <summary>(NW, SW, SE); the one facet of a cell of the northern fan.</summary>
    SouthWest,

    /// <summary>(NW, SE, NE); the one facet of a cell of the southern fan.</summary>
    NorthEast,
}
