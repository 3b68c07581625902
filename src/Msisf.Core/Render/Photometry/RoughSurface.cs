namespace Msisf.Core.Render.Photometry;

/// <summary>The smooth surface that replaces a rough surface in Hapke's law.</summary>
/// <param name="CosIncidence">Cosine of the effective incidence angle, mu_0e.</param>
/// <param name="CosEmission">Cosine of the effective emission angle, mu_e.</param>
/// <param name="Shadowing">Shadowing factor S: the fraction of the light that remains after shadowing.</param>
internal readonly record struct RoughSurface(double CosIncidence, double CosEmission, double Shadowing);
