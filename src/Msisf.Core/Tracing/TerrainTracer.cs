using Msisf.Core.Camera;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tracing;

/// <summary>
/// Traces single rays exactly on the facets of a model, of the whole Moon those of the pattern files (docs/pattern-format.md), for all
/// directions of the ray. It reads only the parts of the model near a ray, when the ray is traced. Safe for several threads.
/// </summary>
/// <remarks>
/// The surface of a whole Moon is closed, so a ray from outside enters the ground before it leaves it. The surface of a map of a part is
/// a sheet that is seen, and throws shadows, from its upper side only: around it there is nothing. Only facets that face the ray are
/// tested. A ray that starts on the ground and leaves it therefore need not skip its own facet, and hits need no minimum distance.
/// <para>
/// It is the ground truth of the renderer, with which it shares the surface only: where the vertices lie, the bounds of nodes, and which
/// cells finer models leave (<see cref="Patch"/>); tests compare these with every facet. Its own are the way down to the facets, from
/// front to back between planes (<see cref="RayWalk"/>, not <see cref="NodeWalk"/>), and the exact tests of facets
/// (<see cref="EdgeFunction"/>).
/// </para>
/// </remarks>
public sealed class TerrainTracer : ISurface, ITerrainTracer
{
    private readonly SurfaceModel _surface;

    /// <summary>Makes a tracer; nothing of the model is read yet.</summary>
    /// <param name="terrain">The elevation model, or several.</param>
    public TerrainTracer(ITerrain terrain) => _surface = SurfaceModel.Of(terrain);

    /// <inheritdoc/>
    public double MaxRadius => _surface.RadiusLimits.Max + Tolerances.VertexLattice;

    /// <inheritdoc/>
    /// <exception cref="ArgumentException">The ray is not finite or has no direction.</exception>
    /// <exception cref="BadInputException">The model has a radius outside the range of the Moon's surface.</exception>
    public bool TryFirstHit(Ray ray, out Vector3D pointBodyFixed)
    {
        bool isHit = TryTrace(ray, out SurfaceHit hit);
        pointBodyFixed = hit.PointBodyFixed;
        return isHit;
    }

    /// <summary>Finds the first facet through which a ray enters the ground.</summary>
    /// <param name="ray">MOON_ME, from a point that is not inside the Moon; on the ground is allowed.</param>
    /// <param name="hit">The point with the facet's normal; <c>default</c> if the ray meets no facet.</param>
    /// <returns>Whether the ray meets a facet.</returns>
    /// <exception cref="ArgumentException">The ray is not finite or has no direction.</exception>
    /// <exception cref="BadInputException">The model has a radius outside the range of the Moon's surface.</exception>
    public bool TryTrace(Ray ray, out SurfaceHit hit)
    {
        RequireRay(ray);
        RayWalk walk = new(_surface, ray, double.PositiveInfinity, stopsAtAnyHit: false);
        walk.Run();
        hit = walk.Facet is FacetId facet
            ? new SurfaceHit(walk.Point, walk.Normal.Normalized(), facet, walk.Parameter)
            : default;
        return walk.Facet is not null;
    }

    /// <summary>
    /// Whether a point of the ground gets no light, because its facet faces away from the light or other terrain is in between.
    /// </summary>
    /// <param name="pointBodyFixed">The point, m, body-fixed, on the facet.</param>
    /// <param name="facet">The facet on which the point lies.</param>
    /// <param name="lightBodyFixed">The Sun or another point of light outside the Moon, m, body-fixed.</param>
    /// <exception cref="ArgumentException">Point or light is not finite, or they are the same.</exception>
    /// <exception cref="BadInputException">The model has a radius outside the range of the Moon's surface.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The model has no such facet.</exception>
    public bool IsHidden(Vector3D pointBodyFixed, FacetId facet, Vector3D lightBodyFixed)
    {
        Ray ray = new(pointBodyFixed, lightBodyFixed - pointBodyFixed);
        RequireRay(ray);
        RequireFacet(facet);
        (Vector3D a, Vector3D b, Vector3D c) = _surface.CornersOf(facet);
        Vector3D normal = Vector3D.Cross(b - a, c - a);
        if (!(Vector3D.Dot(normal, ray.Direction) > 0.0))
        {
            return true;
        }

        RayWalk walk = new(_surface, ray, endParameter: 1.0, stopsAtAnyHit: true);
        walk.Run();
        return walk.Facet is not null;
    }

    private static void RequireRay(Ray ray)
    {
        if (!(ray.Origin.IsFinite && ray.Direction.IsFinite && ray.Direction.LengthSquared > 0.0))
        {
            throw new ArgumentException($"The ray from {ray.Origin} along {ray.Direction} is not finite or has no direction.", nameof(ray));
        }
    }

    private void RequireFacet(FacetId facet)
    {
        if (!_surface.Has(facet))
        {
            throw new ArgumentOutOfRangeException(nameof(facet), facet, "The surface has no such facet.");
        }
    }
}
