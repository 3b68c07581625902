using Msisf.Core.Camera;

namespace Msisf.Core.Tracing;

/// <summary>A surface that a pixel's ray can meet: the reference sphere, or the terrain itself. Safe for several threads.</summary>
public interface ISurface
{
    /// <summary>Finds the first point of the surface in front of the ray's origin.</summary>
    /// <param name="ray">The ray, body-fixed.</param>
    /// <param name="pointBodyFixed">The point, m, body-fixed; the zero vector if there is none.</param>
    /// <returns>Whether the ray meets the surface.</returns>
    bool TryFirstHit(Ray ray, out Vector3D pointBodyFixed);
}
