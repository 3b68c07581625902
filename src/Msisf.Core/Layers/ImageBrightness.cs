namespace Msisf.Core.Layers;

/// <summary>The brightness of one pixel of the image.</summary>
/// <param name="RadianceFactor">I/F, the mean over the pixel's samples; null if the renderer does not know it.</param>
/// <param name="RadianceOfUnitFactor">
/// W m^-2 sr^-1 nm^-1: radiance of the radiance factor 1; null if a lamp at the camera replaces the Sun.
/// </param>
/// <param name="Electrons">Electrons in the detector, before noise; null without a detector.</param>
/// <param name="Saturation">Saturation of the detector's pixel; null without a detector.</param>
internal readonly record struct ImageBrightness(
    double? RadianceFactor, double? RadianceOfUnitFactor, double? Electrons = null, double? Saturation = null)
{
    /// <summary>W m^-2 sr^-1 nm^-1; null if it is unknown.</summary>
    public double? Radiance => RadianceFactor * RadianceOfUnitFactor;
}
