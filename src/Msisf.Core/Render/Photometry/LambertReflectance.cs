namespace Msisf.Core.Render.Photometry;

/// <summary>Lambert's law, which POV-Ray's scene has: equally bright from all sides.</summary>
public sealed class LambertReflectance : IReflectance
{
    /// <summary>Makes the law.</summary>
    /// <param name="albedo">I/F with the Sun in the zenith, 0 to 1.</param>
    public LambertReflectance(double albedo)
    {
        Albedo = Guard.InRange(albedo, 0.0, 1.0, "albedo");
    }

    /// <summary>I/F over the cosine of the incidence angle, for a renderer's own loop.</summary>
    public double Albedo { get; }

    /// <inheritdoc/>
    public bool DependsOnViewer => false;

    /// <inheritdoc/>
    public double RadianceFactor(double cosIncidence, double cosEmission, double phaseHaversine) => Albedo * cosIncidence;
}
