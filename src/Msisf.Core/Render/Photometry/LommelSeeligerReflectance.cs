namespace Msisf.Core.Render.Photometry;

/// <summary>
/// The Lommel-Seeliger law: single scattering by isotropic grains (Hapke 2012, section 8.7). Like the Moon it gives a full disc of equal
/// brightness, but it has no opposition surge.
/// </summary>
public sealed class LommelSeeligerReflectance : IReflectance, IEnclosedLaw
{
    private readonly double _twiceAlbedo;

    /// <summary>Makes the law.</summary>
    /// <param name="albedo">Normal albedo: I/F with the Sun and the viewer at the zenith, 0 to 1.</param>
    public LommelSeeligerReflectance(double albedo)
    {
        _twiceAlbedo = 2.0 * Guard.InRange(albedo, 0.0, 1.0, "albedo");
    }

    /// <summary>The law as a user names it.</summary>
    public static ReflectanceLaw Law { get; } = new("lommel-seeliger", values => new LommelSeeligerReflectance(values.Albedo));

    /// <inheritdoc/>
    public bool DependsOnViewer => true;

    /// <inheritdoc/>
    public double RadianceFactor(double cosIncidence, double cosEmission, double phaseHaversine) =>
        _twiceAlbedo * cosIncidence / (cosIncidence + cosEmission);

    Sloped IEnclosedLaw.Enclose(in Sloped cosIncidence, in Sloped cosEmission, in Sloped phaseHaversine) =>
        _twiceAlbedo / (1.0 + (cosEmission / cosIncidence));
}
