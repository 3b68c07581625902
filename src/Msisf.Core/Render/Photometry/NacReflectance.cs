namespace Msisf.Core.Render.Photometry;

/// <summary>
/// The empirical law of 2019 with which the images of the LROC Narrow Angle Cameras are normalised: the Lommel-Seeliger term times an
/// exponential of the angles.
/// </summary>
public sealed class NacReflectance : IReflectance
{
    private const double Constant = -1.479654495;
    private const double PhaseSquared = -8.3528e-5; // per square degree
    private const double Phase = 0.012964707; // per degree
    private const double PhaseRoot = -0.237774774; // per root of a degree
    private const double Emission = 0.556075496;
    private const double Incidence = 0.66367146;
    private const double IncidenceSquared = -0.439918609;

    /// <summary>The law as a user names it.</summary>
    public static ReflectanceLaw Law { get; } = new("nac", _ => new NacReflectance()) { HasOwnBrightness = true };

    /// <inheritdoc/>
    public bool DependsOnViewer => true;

    /// <inheritdoc/>
    public double RadianceFactor(double cosIncidence, double cosEmission, double phaseHaversine)
    {
        double g = double.RadiansToDegrees(PhaseAngle.FromHaversine(phaseHaversine));
        double exponent = Constant + (g * ((PhaseSquared * g) + Phase)) + (PhaseRoot * Math.Sqrt(g))
            + (Emission * cosEmission) + (cosIncidence * (Incidence + (IncidenceSquared * cosIncidence)));
        return cosIncidence / (cosEmission + cosIncidence) * Math.Exp(exponent);
    }
}
