namespace Msisf.Core.Render.Photometry;

/// <summary>A reflectance law: how a surface reflects sunlight (docs/photometry.md). Safe for several threads.</summary>
public interface IReflectance
{
    /// <summary>Whether the radiance depends on the viewing direction; if not, the emission and phase angles are ignored.</summary>
    bool DependsOnViewer { get; }

    /// <summary>
    /// The radiance factor I/F: pi times the radiance towards the viewer, divided by the Sun's irradiance on a surface perpendicular to the
    /// sunlight.
    /// </summary>
    /// <param name="cosIncidence">Cosine of the incidence angle, above 0, up to 1. Points without sunlight must not be passed.</param>
    /// <param name="cosEmission">Cosine of the emission angle, above 0, up to 1.</param>
    /// <param name="phaseHaversine">sin^2 of half the phase angle, 0 to 1 (<see cref="PhaseAngle"/>).</param>
    /// <returns>I/F: finite and at least 0; values above 1 are possible.</returns>
    double RadianceFactor(double cosIncidence, double cosEmission, double phaseHaversine);

    /// <summary>The radiance factors of many points; 0 where a cosine is not above 0.</summary>
    /// <param name="cosIncidence">Cosines of the incidence angles.</param>
    /// <param name="cosEmission">Cosines of the emission angles, as many.</param>
    /// <param name="phaseHaversine">Haversines of the phase angles, as many.</param>
    /// <param name="factors">Receives as many radiance factors.</param>
    void RadianceFactors(
        ReadOnlySpan<double> cosIncidence, ReadOnlySpan<double> cosEmission, ReadOnlySpan<double> phaseHaversine, Span<double> factors)
    {
        for (int i = 0; i < cosIncidence.Length; i++)
        {
            factors[i] = cosIncidence[i] > 0.0 && cosEmission[i] > 0.0
                ? RadianceFactor(cosIncidence[i], cosEmission[i], phaseHaversine[i])
                : 0.0;
        }
    }
}
