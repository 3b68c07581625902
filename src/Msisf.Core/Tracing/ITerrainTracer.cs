using Msisf.Core.Camera;
using Msisf.Core.Surface;

namespace Msisf.Core.Tracing;

/// <summary>Traces single rays through the closed surface that the pattern files draw, exactly. Safe for several threads.</summary>
public interface ITerrainTracer
{
    /// <summary>m: no ground is farther from the body's centre.</summary>
    double MaxRadius { get; }

    /// <summary>Finds the first facet through which a ray enters the ground.</summary>
    /// <param name="ray">MOON_ME, from a point that is not inside the Moon.</param>
    /// <param name="hit">The point with the facet's normal; <c>default</c> if the ray meets no facet.</param>
    /// <returns>Whether the ray meets a facet.</returns>
    bool TryTrace(Ray ray, out SurfaceHit hit);

    /// <summary>
    /// Whether a point of the ground gets no light, because its facet faces away from the light or other terrain is in between.
    /// </summary>
    /// <param name="pointBodyFixed">The point, m, body-fixed, on the facet.</param>
    /// <param name="facet">The facet on which the point lies.</param>
    /// <param name="lightBodyFixed">The Sun or another point of light outside the Moon, m, body-fixed.</param>
    bool IsHidden(Vector3D pointBodyFixed, FacetId facet, Vector3D lightBodyFixed);
}

/// <summary>Where a ray meets the terrain.</summary>
/// <param name="PointBodyFixed">The point on the facet, m, body-fixed.</param>
/// <param name="NormalBodyFixed">
/// Outward normal with which the point is shaded, body-fixed, length 1: the facet's normal, or one interpolated between the surrounding
/// samples.
/// </param>
/// <param name="Facet">The facet that is met.</param>
/// <param name="RayParameter">Ray parameter t of the point: origin + t direction.</param>
public readonly record struct SurfaceHit(Vector3D PointBodyFixed, Vector3D NormalBodyFixed, FacetId Facet, double RayParameter);
