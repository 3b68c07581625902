namespace Msisf.Core.Render.Photometry;

/// <summary>The six parameters of Hapke's law. The one without arguments is the Moon.</summary>
/// <remarks>
/// The Moon's: averages of the maps of Sato et al., J. Geophys. Res. Planets 119 (2014), p. 1775, as printed to five digits in table 1 of
/// arXiv:2410.04371. Like them, without coherent backscatter (B_C0 = 0) and with the porosity factor K = 1.
/// </remarks>
public sealed class HapkeParameters
{
    /// <summary>Checks the parameters.</summary>
    /// <param name="singleScatteringAlbedo">w, 0 to 1.</param>
    /// <param name="lobeWidth">b of the Henyey-Greenstein lobes, 0 (isotropic) to 0.95.</param>
    /// <param name="backwardWeight">c of the lobes, -1 (all forward) to 1 (all backward).</param>
    /// <param name="surgeAmplitude">B0 of the opposition surge, 0 to 10.</param>
    /// <param name="surgeWidth">h of the opposition surge: tangent of half the phase angle at half its height, 0.0001 to 10.</param>
    /// <param name="meanSlopeDegrees">Theta-bar of the roughness, degrees, 0 (smooth) to 60.</param>
    /// <exception cref="Errors.BadInputException">One is out of range.</exception>
    public HapkeParameters(
        double singleScatteringAlbedo = 0.32357,
        double lobeWidth = 0.23955,
        double backwardWeight = 0.30452,
        double surgeAmplitude = 1.80238,
        double surgeWidth = 0.07145,
        double meanSlopeDegrees = 23.4)
    {
        SingleScatteringAlbedo = Guard.InRange(singleScatteringAlbedo, 0.0, 1.0, "hapke parameter w");
        LobeWidth = Guard.InRange(lobeWidth, 0.0, 0.95, "hapke parameter b");
        BackwardWeight = Guard.InRange(backwardWeight, -1.0, 1.0, "hapke parameter c");
        SurgeAmplitude = Guard.InRange(surgeAmplitude, 0.0, 10.0, "hapke parameter b0");
        SurgeWidth = Guard.InRange(surgeWidth, 1e-4, 10.0, "hapke parameter h");
        MeanSlopeDegrees = Guard.InRange(meanSlopeDegrees, 0.0, 60.0, "hapke parameter theta (degrees)");
    }

    /// <summary>w.</summary>
    public double SingleScatteringAlbedo { get; }

    /// <summary>b.</summary>
    public double LobeWidth { get; }

    /// <summary>c.</summary>
    public double BackwardWeight { get; }

    /// <summary>B0.</summary>
    public double SurgeAmplitude { get; }

    /// <summary>h.</summary>
    public double SurgeWidth { get; }

    /// <summary>Theta-bar, degrees.</summary>
    public double MeanSlopeDegrees { get; }
}
