namespace Msisf.Core.Layers;

/// <summary>Layer values of the brightness of a pixel.</summary>
internal static class ImageValues
{
    public static double? RadianceFactor(in PixelTruth pixel, int plane) => pixel.Brightness.RadianceFactor;

    public static double? Electrons(in PixelTruth pixel, int plane) => pixel.Brightness.Electrons;

    public static double? Saturation(in PixelTruth pixel, int plane) => pixel.Brightness.Saturation;

    public static double? Radiance(in PixelTruth pixel, int plane) => pixel.Brightness.Radiance;
}
