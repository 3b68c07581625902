namespace Msisf.Core.Render.Shading;

/// <summary>The light on a frame's pixels, row by row.</summary>
/// <param name="CosIncidence">Cosine of the incidence angle on the facet; 0 where there is no surface, or it faces away.</param>
/// <param name="Hidden">Not 0 if other terrain hides the light.</param>
internal readonly record struct PixelSunlight(double[] CosIncidence, byte[] Hidden);
