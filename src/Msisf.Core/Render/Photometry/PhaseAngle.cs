namespace Msisf.Core.Render.Photometry;

/// <summary>
/// The phase angle g as its haversine, sin^2(g/2). Unlike the angle, it needs no transcendental function for each pixel. Unlike the cosine,
/// it keeps all its digits at opposition, where the laws change fastest.
/// </summary>
public static class PhaseAngle
{
    /// <summary>The phase angle, rad, 0 to pi, of a haversine from 0 to 1.</summary>
    public static double FromHaversine(double haversine) => 2.0 * Math.Atan2(Math.Sqrt(haversine), Math.Sqrt(1.0 - haversine));

    /// <summary>Tangent of half the phase angle of a haversine from 0 to 1; infinite for 1.</summary>
    public static double HalfTangent(double haversine) => Math.Sqrt(haversine / (1.0 - haversine));
}
