using Msisf.Core.Metadata;
using Msisf.Core.Numerics;

namespace Msisf.Core.Layers;

/// <summary>Layer values of how the surface point of a pixel is lit, and of the angles to light and camera.</summary>
internal static class LightValues
{
    public static double? Incidence(PixelTruth pixel, int plane) => DegreesBetween(pixel.Hit.NormalMoonMe, pixel.ToLightMoonMe);

    public static double? Emission(PixelTruth pixel, int plane) => DegreesBetween(pixel.Hit.NormalMoonMe, -pixel.LineOfSightMoonMe);

    public static double? Phase(PixelTruth pixel, int plane) => DegreesBetween(pixel.ToLightMoonMe, -pixel.LineOfSightMoonMe);

    /// <summary>Illumination direction in degrees, the same as in the meta file.</summary>
    public static double? Direction(PixelTruth pixel, int plane) =>
        IlluminationDirection.At(
            pixel.Camera, pixel.LineOfSightMoonMe, pixel.LineOfSightLength, pixel.Hit.PointMoonMe, pixel.Radius,
            pixel.LightPositionMoonMe) is double angle
            ? double.RadiansToDegrees(angle)
            : null;

    public static double? State(PixelTruth pixel, int plane) => (double)pixel.Light.State;

    public static double? VisibleFraction(PixelTruth pixel, int plane) => pixel.Light.VisibleFraction;

    /// <summary>Angle in degrees, [0, 180]; within 1e-15 rad of Kahan's formula in <see cref="Vector3D"/>, three times as fast.</summary>
    private static double DegreesBetween(Vector3D u, Vector3D v)
    {
        // Lengths lie between 1e-12 (a camera of the narrowest field) and 1e20, so squares neither overflow nor vanish.
        double sine = Math.Sqrt(Vector3D.Cross(u, v).LengthSquared);
        return double.RadiansToDegrees(Math.Atan2(sine, Vector3D.Dot(u, v)));
    }
}
