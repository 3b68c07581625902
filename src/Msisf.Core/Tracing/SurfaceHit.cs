using Msisf.Core.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Tracing;

/// <summary>Where a ray meets the terrain.</summary>
/// <param name="PointMoonMe">The point on the facet, m, MOON_ME.</param>
/// <param name="NormalMoonMe">
/// Outward normal with which the point is shaded, MOON_ME, length 1: the facet's normal, or one interpolated between the surrounding
/// samples.
/// </param>
/// <param name="Facet">The facet that is met.</param>
/// <param name="RayParameter">Ray parameter t of the point: origin + t direction.</param>
public readonly record struct SurfaceHit(Vector3D PointMoonMe, Vector3D NormalMoonMe, FacetId Facet, double RayParameter);
