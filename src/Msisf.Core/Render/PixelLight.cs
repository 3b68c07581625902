namespace Msisf.Core.Render;

/// <summary>The Sun as a pixel's surface point sees it; <c>default</c> is a pixel without surface.</summary>
/// <param name="State">Lit, penumbra, shadow or night.</param>
/// <param name="VisibleFraction">Part of the Sun's disc that is not hidden by terrain, 0 to 1.</param>
public readonly record struct PixelLight(SunState State, double VisibleFraction);
