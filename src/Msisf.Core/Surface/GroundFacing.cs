using Msisf.Core.Numerics;

namespace Msisf.Core.Surface;

/// <summary>Tells from the slope of a part's steepest facet whether its ground faces a viewpoint.</summary>
internal static class GroundFacing
{
    /// <summary>Whether all facets of a part certainly face away from a viewpoint.</summary>
    /// <param name="nearest">Minimum angle at the Moon's centre between the viewpoint and a point of the part.</param>
    /// <param name="distance">m: the viewpoint's distance from the Moon's centre.</param>
    /// <param name="minRadius">m: minimum radius of the facets.</param>
    /// <param name="maxSlope">Tangent of the maximum slope of the facets.</param>
    /// <remarks>
    /// The viewpoint stands D cos(theta) - r over a point's level at a distance D sin(theta) to the side. cos(theta) + maxSlope sin(theta)
    /// falls from where its slope is the steepest one.
    /// </remarks>
    public static bool IsTurnedAway(SineCosine nearest, double distance, double minRadius, double maxSlope) =>
        nearest.Sine > 0.0
        && nearest.Sine > maxSlope * nearest.Cosine
        && nearest.Cosine + (maxSlope * nearest.Sine) < minRadius / distance;
}
