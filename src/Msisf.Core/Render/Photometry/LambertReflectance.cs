namespace Msisf.Core.Render.Photometry;

/// <summary>Lambert's law, which POV-Ray's scene uses: the radiance is the same in all viewing directions.</summary>
public sealed class LambertReflectance : IReflectance, IEnclosedLaw
{
    /// <summary>Makes the law.</summary>
    /// <param name="albedo">I/F with the Sun at the zenith, 0 to 1.</param>
    public LambertReflectance(double albedo)
    {
        Albedo = Guard.InRange(albedo, 0.0, 1.0, "albedo");
    }

    /// <summary>The law as a user names it.</summary>
    public static ReflectanceLaw Law { get; } = new("lambert", values => new LambertReflectance(values.Albedo));

    /// <summary>I/F divided by the cosine of the incidence angle, for a renderer that computes the law in its own loop.</summary>
    public double Albedo { get; }

    /// <inheritdoc/>
    public bool DependsOnViewer => false;

    /// <inheritdoc/>
    public double RadianceFactor(double cosIncidence, double cosEmission, double phaseHaversine) => Albedo * cosIncidence;

    Sloped IEnclosedLaw.Enclose(in Sloped cosIncidence, in Sloped cosEmission, in Sloped phaseHaversine) => Albedo * cosIncidence;
}
