namespace Msisf.Core.Render.Shadows;

/// <summary>The light of the Sun's disc on a point of a facet; <c>default</c> is no light.</summary>
/// <param name="VisibleFraction">Fraction of the disc's area that neither terrain nor the facet's own plane hides, 0 to 1.</param>
/// <param name="Irradiance">Mean over the whole disc of the cosine of the incidence angle; hidden parts count as 0.</param>
internal readonly record struct DiscLight(double VisibleFraction, double Irradiance);
