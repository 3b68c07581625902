using Msisf.Core.Camera;
using Msisf.Core.Mesh;
using Msisf.Core.Numerics;

namespace Msisf.Core.Tracing;

/// <summary>Traces single rays through the closed surface that the pattern files draw, exactly. Safe for several threads.</summary>
public interface ITerrainTracer
{
    /// <summary>The first facet through which a ray enters the ground.</summary>
    /// <param name="ray">MOON_ME, from a point that is not inside the Moon.</param>
    /// <param name="hit">The point, with the facet's normal; <c>default</c> if there is none.</param>
    /// <returns>Whether there is one.</returns>
    bool TryTrace(Ray ray, out SurfaceHit hit);

    /// <summary>Whether a point of the ground gets no light: its facet faces away, or other terrain is in between.</summary>
    /// <param name="pointMoonMe">m, MOON_ME, on the facet.</param>
    /// <param name="facet">The facet on which the point lies.</param>
    /// <param name="lightMoonMe">The Sun or another point of light outside the Moon, m, MOON_ME.</param>
    bool IsHidden(Vector3D pointMoonMe, FacetId facet, Vector3D lightMoonMe);
}
