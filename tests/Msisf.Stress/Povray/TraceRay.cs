using Msisf.Core.Numerics;

namespace Msisf.Stress.Povray;

/// <summary>A ray, and where exactly it meets a block.</summary>
/// <param name="StartKm">km, MOON_ME, the very numbers that POV-Ray gets.</param>
/// <param name="Direction">Length 1.</param>
/// <param name="HitKm">km, on the facet.</param>
/// <param name="Normal">The facet's, outward, length 1.</param>
/// <param name="EdgeKm">From the hit to the facet's nearest edge.</param>
/// <param name="OriginKm">The tile's origin, from which POV-Ray counts in a tile-local mesh.</param>
internal sealed record TraceRay(Vector3D StartKm, Vector3D Direction, Vector3D HitKm, Vector3D Normal, double EdgeKm, Vector3D OriginKm)
{
    /// <summary>From the start to the hit, km.</summary>
    public double LengthKm => (HitKm - StartKm).Length;

    /// <summary>From the tile's origin to the hit, km.</summary>
    public double HitFromOriginKm => (HitKm - OriginKm).Length;

    /// <summary>Of the angle between ray and normal, not below 0.</summary>
    public double Cosine => Math.Abs(Vector3D.Dot(Direction, Normal));

    /// <summary>
    /// How far the hit goes when start and direction are rounded to 32-bit floats, in parts of the way to the facet's edge. POV-Ray asks
    /// with such a ray which boxes of triangles it meets (Rayinfo); above 1 it may ask past the facet.
    /// </summary>
    public double RoundedPastEdge =>
        2.0 * TracePrecisionStress.FloatUnit * (StartKm - OriginKm).Length / (Cosine * EdgeKm);
}
