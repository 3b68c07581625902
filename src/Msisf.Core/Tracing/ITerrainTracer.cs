using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Tracing;

/// <summary>Traces single rays through the closed surface that the pattern files draw, exactly. Safe for several threads.</summary>
public interface ITerrainTracer
{
    /// <summary>Finds the first facet through which a ray enters the ground.</summary>
    /// <param name="ray">MOON_ME, from a point that is not inside the Moon.</param>
    /// <param name="hit">The point with the facet's normal; <c>default</c> if the ray meets no facet.</param>
    /// <returns>Whether the ray meets a facet.</returns>
    bool TryTrace(Ray ray, out SurfaceHit hit);

    /// <summary>
    /// Whether a point of the ground gets no light, because its facet faces away from the light or other terrain is in between.
    /// </summary>
    /// <param name="pointMoonMe">The point, m, MOON_ME, on the facet.</param>
    /// <param name="facet">The facet on which the point lies.</param>
    /// <param name="lightMoonMe">The Sun or another point of light outside the Moon, m, MOON_ME.</param>
    bool IsHidden(Vector3D pointMoonMe, FacetId facet, Vector3D lightMoonMe);
}

/// <summary>Where a ray meets the terrain.</summary>
/// <param name="PointMoonMe">The point on the facet, m, MOON_ME.</param>
/// <param name="NormalMoonMe">
/// Outward normal with which the point is shaded, MOON_ME, length 1: the facet's normal, or one interpolated between the surrounding
/// samples.
/// </param>
/// <param name="Facet">The facet that is met.</param>
/// <param name="RayParameter">Ray parameter t of the point: origin + t direction.</param>
public readonly record struct SurfaceHit(Vector3D PointMoonMe, Vector3D NormalMoonMe, FacetId Facet, double RayParameter);
