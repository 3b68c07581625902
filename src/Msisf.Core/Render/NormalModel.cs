namespace Msisf.Core.Render;

/// <summary>Which normal shades a point of a facet. The point itself and its shadow are the facet's either way.</summary>
public enum NormalModel
{
    /// <summary>The facet's own.</summary>
    Facet,

    /// <summary>Between those of the samples around, so that edges between facets are not seen.</summary>
    Smooth,
}
