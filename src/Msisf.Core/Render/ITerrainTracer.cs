using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Render;

/// <summary>Traces single rays through the closed surface that the pattern files draw, exactly. Safe for several threads.</summary>
public interface ITerrainTracer
{
    /// <summary>The first facet in front of a ray's origin.</summary>
    /// <param name="ray">MOON_ME, m; the origin lies above the surface.</param>
    /// <param name="hit">What is met, with the facet's normal; <c>default</c> if nothing is.</param>
    /// <returns>Whether the ray meets the surface.</returns>
    bool TryTrace(Ray ray, out SurfaceHit hit);

    /// <summary>Whether other terrain lies between a point of a facet and the light.</summary>
    /// <param name="pointMoonMe">m, on the facet.</param>
    /// <param name="facet">The facet; it does not hide its own points.</param>
    /// <param name="lightMoonMe">The Sun, or the lamp that stands for it, m.</param>
    bool IsHidden(Vector3D pointMoonMe, FacetId facet, Vector3D lightMoonMe);
}
