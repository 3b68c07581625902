namespace Msisf.Core.Render.Photometry;

/// <summary>How a surface reflects sunlight (docs/photometry.md). Safe for several threads.</summary>
public interface IReflectance
{
    /// <summary>Whether the radiance depends on where it is seen from; if not, emission and phase need not be right.</summary>
    bool DependsOnViewer { get; }

    /// <summary>
    /// The radiance factor I/F: pi times the radiance towards the viewer over the Sun's irradiance on a surface that faces it.
    /// </summary>
    /// <param name="cosIncidence">
    /// Cosine of the incidence angle, above 0, up to 1: a point without sunlight has no radiance to ask for.
    /// </param>
    /// <param name="cosEmission">Cosine of the emission angle, above 0, up to 1.</param>
    /// <param name="phaseHaversine">sin^2 of half the phase angle, 0 to 1 (<see cref="PhaseAngle"/>).</param>
    /// <returns>Finite, 0 or more; above 1 is possible.</returns>
    double RadianceFactor(double cosIncidence, double cosEmission, double phaseHaversine);
}
