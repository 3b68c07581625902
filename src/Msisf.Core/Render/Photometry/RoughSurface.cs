namespace Msisf.Core.Render.Photometry;

/// <summary>A rough surface as the smooth one that replaces it in Hapke's law.</summary>
/// <param name="CosIncidence">Cosine of the effective incidence angle, mu_0e.</param>
/// <param name="CosEmission">Cosine of the effective emission angle, mu_e.</param>
/// <param name="Shadowing">S: the part of the light that shadows leave.</param>
internal readonly record struct RoughSurface(double CosIncidence, double CosEmission, double Shadowing);
