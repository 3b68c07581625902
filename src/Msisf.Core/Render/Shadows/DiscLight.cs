namespace Msisf.Core.Render.Shadows;

/// <summary>The Sun's disc as a facet sees it; <c>default</c> is the dark.</summary>
/// <param name="VisibleFraction">Part of the disc that neither terrain nor the facet's own plane hides, 0 to 1.</param>
/// <param name="Irradiance">Mean over the whole disc of the cosine of the incidence angle, 0 for the parts that are hidden.</param>
internal readonly record struct DiscLight(double VisibleFraction, double Irradiance);
