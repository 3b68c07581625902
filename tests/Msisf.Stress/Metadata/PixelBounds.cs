using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Stress.Camera;

namespace Msisf.Stress.Metadata;

/// <summary>
/// How far a pixel's coordinates and illumination direction may be from the true ones, degrees: the limits of the stress tests, as
/// formulas.
/// </summary>
/// <remarks>
/// The hit point is off by up to <see cref="HitBounds.OnSphere"/>. Seen from the Moon's centre that is the error of the latitude; on a
/// parallel it is more of the longitude by the cosine of the latitude. The direction of the ground line towards the Sun turns by more
/// than the point the nearer the Sun is to the zenith, and its image by more the more it is seen end on: by the sines of
/// the two (<see cref="Reference.PrecisePixel.DirectionSine"/>). Rounding the angle in rad, in degrees and to 16 digits adds a last digit
/// each.
/// </remarks>
internal static class PixelBounds
{
    /// <summary>degrees: what is promised of latitude and longitude wherever <see cref="Coordinate"/> does not allow more.</summary>
    public const double PromisedCoordinate = 1e-10;

    /// <summary>degrees: what is promised of the illumination direction wherever <see cref="Direction"/> does not allow more.</summary>
    public const double PromisedDirection = 1e-9;

    /// <summary>degrees: half a last bit of 2 pi rad and of 360 degrees, and half of the 16th digit.</summary>
    private const double LastDigits = 1.1e-13;

    /// <summary>
    /// Roundings of the zenith, of the direction to the Sun, and of the two cross products, on the way to the illumination direction.
    /// </summary>
    private const double DirectionRoundings = 8.0;

    /// <summary>degrees, of a latitude, or of a longitude at such a latitude.</summary>
    /// <param name="camera">m, MOON_ME.</param>
    /// <param name="cosEmission">Of the angle between line of sight and zenith.</param>
    /// <param name="cosLatitude">1 for the latitude itself.</param>
    public static double Coordinate(Vector3D camera, double cosEmission, double cosLatitude) =>
        Math.Min(180.0, double.RadiansToDegrees(PointAngle(camera, cosEmission) / cosLatitude) + LastDigits);

    /// <summary>degrees, of an illumination direction.</summary>
    /// <param name="camera">m, MOON_ME.</param>
    /// <param name="cosEmission">Of the angle between line of sight and zenith.</param>
    /// <param name="sine">Of the Sun's zenith angle times that between ground line and line of sight, in the image.</param>
    public static double Direction(Vector3D camera, double cosEmission, double sine) => Math.Min(
        180.0, double.RadiansToDegrees(DirectionSine(camera, cosEmission) / sine) + LastDigits);

    /// <summary>1: the error of that sine.</summary>
    public static double DirectionSine(Vector3D camera, double cosEmission) =>
        PointAngle(camera, cosEmission) + (DirectionRoundings * RayMeasure.Rounding);

    /// <summary>rad: the error of the hit point from the Moon's centre.</summary>
    private static double PointAngle(Vector3D camera, double cosEmission) =>
        HitBounds.OnSphere(camera, cosEmission) / MoonConstants.ReferenceRadius;
}
