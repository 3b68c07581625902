using Msisf.Core.Camera;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.Stress.Reference;

namespace Msisf.Stress.Camera;

/// <summary>
/// Judges whether the facet that the tracer names is the first that a ray enters: by rays against every facet, and to 30 digits where those
/// doubt.
/// </summary>
public sealed class FacetJudge
{
    /// <summary>m: the tracer moves an origin that is farther from the Moon's centre along its ray.</summary>
    private const double FarOrigin = MoonConstants.ReferenceRadius + MoonConstants.MaxRelief;

    /// <summary>
    /// m: rounding the moved origin to doubles moves the ray by up to 2e-10 m; so near to an edge either neighbour is right.
    /// </summary>
    private const double MovedOrigin = 1e-9;

    /// <summary>
    /// m along the ray: points nearer to each other than this are one point in doubles, whose coordinates are rounded by up to 1.2e-10 m.
    /// Of two facets that a ray enters there, at a vertex that both have, either is right.
    /// </summary>
    private const double OnePoint = 1e-9;

    private readonly TerrainUnderTest _terrain;

    internal FacetJudge(TerrainUnderTest terrain) => _terrain = terrain;

    /// <summary>For the real LDEM_4.</summary>
    public static FacetJudge OfRealModel() => new(new TerrainUnderTest(JudgedMoon.Real));

    /// <summary>What the tracer says of a ray; null if it meets nothing.</summary>
    public SurfaceHit? Trace(Ray ray) => _terrain.Tracer.TryTrace(ray, out SurfaceHit hit) ? hit : null;

    /// <summary>Whether the ray, as the doubles have it, does not enter the named facet, or enters another one before.</summary>
    /// <param name="ray">MOON_ME.</param>
    /// <param name="hit">What is said of it; null: that it meets nothing.</param>
    public bool IsWrong(Ray ray, SurfaceHit? hit)
    {
        PreciseVector origin = PreciseVector.From(ray.Origin);
        PreciseVector direction = PreciseVector.From(ray.Direction);
        double doubt = ray.Origin.Length > FarOrigin ? MovedOrigin : 0.0;
        PreciseFacet? named = hit is null ? null : _terrain.PreciseFacetOf(hit.Value.Facet);
        if (named is not null && !(hit!.Value.PointBodyFixed.IsFinite && named.Value.Inside(origin, direction) >= -doubt))
        {
            return true;
        }

        if (FirstByBruteForce(origin, direction) is not FacetId first || first == hit?.Facet)
        {
            return false;
        }

        PreciseFacet other = _terrain.PreciseFacetOf(first);
        return other.Inside(origin, direction) > doubt
            && !(named is not null && MetresBehind(other, named.Value, origin, direction) <= OnePoint);
    }

    /// <summary>m along the ray from one facet's plane to the other's.</summary>
    private static double MetresBehind(PreciseFacet from, PreciseFacet to, PreciseVector origin, PreciseVector direction) =>
        ((to.ParameterOn(origin, direction) - from.ParameterOn(origin, direction)) * direction.Length).High;

    private FacetId? FirstByBruteForce(PreciseVector origin, PreciseVector direction)
    {
        // From 1e12 m doubles would know the facets to 1e-4 m: a far origin is moved to the ray's nearest approach less a lunar diameter.
        double distance = origin.Length.High;
        double length = direction.Length.High;
        double approach = -(PreciseVector.Dot(origin, direction) / direction.Length).High;
        double shift = Math.Max(0.0, Math.Min(approach, distance) - (2.0 * MoonConstants.ReferenceRadius)) / length;
        (BruteForceMoon.FacetId Facet, double T)? hit = _terrain.Facets.FirstHit((origin + (shift * direction)).Rounded, direction.Rounded);
        return hit is null ? null : TerrainUnderTest.FacetOf(hit.Value.Facet);
    }
}
