namespace Msisf.Core.Render;

/// <summary>The normal with which a point of a facet is shaded. The point and its shadow always belong to the facet itself.</summary>
public enum NormalModel
{
    /// <summary>The normal of the facet.</summary>
    Facet,

    /// <summary>A normal interpolated between those of the surrounding samples, so that edges between facets are not visible.</summary>
    Smooth,
}
