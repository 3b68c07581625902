namespace Msisf.Core.Layers;

/// <summary>The brightness of one pixel of the image.</summary>
/// <param name="RadianceFactor">I/F, the mean over the pixel's samples; null if the renderer does not know it.</param>
/// <param name="RadianceOfUnitFactor">
/// W m^-2 sr^-1 nm^-1: radiance of the radiance factor 1; null if a lamp at the camera replaces the Sun.
/// </param>
internal readonly record struct ImageBrightness(double? RadianceFactor, double? RadianceOfUnitFactor)
{
    /// <summary>W m^-2 sr^-1 nm^-1; null if it is unknown.</summary>
    public double? Radiance => RadianceFactor * RadianceOfUnitFactor;
}
