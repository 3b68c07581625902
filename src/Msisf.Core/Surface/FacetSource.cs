namespace Msisf.Core.Surface;

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
