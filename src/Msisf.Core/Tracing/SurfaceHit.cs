using Msisf.Core.Mesh;
using Msisf.Core.Numerics;

namespace Msisf.Core.Tracing;

/// <summary>Where a ray meets the terrain.</summary>
/// <param name="PointMoonMe">m, MOON_ME, on the facet.</param>
/// <param name="NormalMoonMe">
/// Outward normal that shades the point, MOON_ME, length 1: the facet's, or one between the samples around.
/// </param>
/// <param name="Facet">The facet that is met.</param>
/// <param name="RayParameter">t of origin + t direction.</param>
public readonly record struct SurfaceHit(Vector3D PointMoonMe, Vector3D NormalMoonMe, FacetId Facet, double RayParameter);
