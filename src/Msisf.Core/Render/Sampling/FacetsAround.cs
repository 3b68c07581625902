namespace Msisf.Core.Render.Sampling;

/// <summary>How the facets that a pixel's four neighbours show lie to the one that the pixel's centre shows.</summary>
internal enum FacetsAround : byte
{
    /// <summary>They are the same facet, or meet it in straight lines of which at most one crosses the pixel.</summary>
    OneLine,

    /// <summary>They meet it in straight lines of which several cross the pixel.</summary>
    Lines,

    /// <summary>
    /// One meets it in no line between the two, as at a silhouette, or none of them is the same: facets are about as small as pixels.
    /// </summary>
    Other,
}
