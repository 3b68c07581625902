namespace Msisf.Core.Layers;

/// <summary>Layer values of the brightness of a pixel.</summary>
internal static class ImageValues
{
    public static double? RadianceFactor(PixelTruth pixel, int plane) => pixel.Brightness.RadianceFactor;

    public static double? Electrons(PixelTruth pixel, int plane) => pixel.Brightness.Electrons;

    public static double? Saturation(PixelTruth pixel, int plane) => pixel.Brightness.Saturation;

    public static double? Radiance(PixelTruth pixel, int plane) => pixel.Brightness.Radiance;
}
