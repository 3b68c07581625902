using Msisf.Core.Numerics;

namespace Msisf.Core.Layers;

/// <summary>Layer values of the surface's inclination against the sphere.</summary>
internal static class SlopeValues
{
    /// <summary>Degrees between the normal and the radius.</summary>
    public static double? Slope(PixelTruth pixel, int plane) =>
        double.RadiansToDegrees(Vector3D.AngleBetween(
            pixel.Hit.NormalMoonMe, pixel.Hit.NormalMoonMe.Length, pixel.Hit.PointMoonMe, pixel.Radius));

    /// <summary>Degrees from north over east to the direction in which the ground falls.</summary>
    public static double? Aspect(PixelTruth pixel, int plane)
    {
        Vector3D up = pixel.Zenith;
        Vector3D east = Vector3D.Cross(Vector3D.UnitZ, up);
        double eastLength = east.Length;
        if (eastLength < Tolerances.ParallelSine)
        {
            return null; // the polar axis has no north
        }

        // The horizontal part of the outward normal leads downhill.
        Vector3D north = Vector3D.Cross(up, east);
        double toEast = Vector3D.Dot(pixel.Hit.NormalMoonMe, east);
        double toNorth = Vector3D.Dot(pixel.Hit.NormalMoonMe, north);
        if (double.Hypot(toEast, toNorth) < Tolerances.LevelSlope * eastLength)
        {
            return null;
        }

        double azimuth = double.RadiansToDegrees(Math.Atan2(toEast, toNorth));
        return azimuth < 0.0 ? Math.Min(azimuth + 360.0, Math.BitDecrement(360.0)) : azimuth;
    }

    /// <summary>Degrees between the radius and the direction to the Sun.</summary>
    public static double? SphereIncidence(PixelTruth pixel, int plane) =>
        double.RadiansToDegrees(Vector3D.AngleBetween(pixel.Hit.PointMoonMe, pixel.Radius, pixel.ToLightMoonMe, pixel.LightDistance));
}
