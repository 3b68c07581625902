using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Photometry;

/// <summary>
/// The phase angle g as its haversine, sin^2(g/2). Unlike the angle, it needs no transcendental function for each pixel. Unlike the cosine,
/// it keeps all its digits at opposition, where the laws change fastest.
/// </summary>
public static class PhaseAngle
{
    /// <summary>Haversine of the angle between two directions.</summary>
    /// <param name="sunDirection">From the surface point to the Sun, length 1.</param>
    /// <param name="viewerDirection">From the surface point to the viewer, same frame, length 1.</param>
    /// <returns>0 (the Sun behind the viewer) to 1.</returns>
    public static double Haversine(Vector3D sunDirection, Vector3D viewerDirection)
    {
        Vector3D difference = sunDirection - viewerDirection;
        return Math.Min(0.25 * Vector3D.Dot(difference, difference), 1.0);
    }

    /// <summary>The phase angle, rad, 0 to pi, of a haversine from 0 to 1.</summary>
    public static double FromHaversine(double haversine) => 2.0 * Math.Atan2(Math.Sqrt(haversine), Math.Sqrt(1.0 - haversine));

    /// <summary>Tangent of half the phase angle of a haversine from 0 to 1; infinite for 1.</summary>
    public static double HalfTangent(double haversine) => Math.Sqrt(haversine / (1.0 - haversine));
}
