namespace Msisf.Core.Render.Photometry;

/// <summary>The six parameters of Hapke's law; the default values are those of the Moon.</summary>
/// <remarks>
/// Source of the default values: averages of the maps of Sato et al., J. Geophys. Res. Planets 119 (2014), p. 1775, as printed to five
/// digits in table 1 of arXiv:2410.04371. As there, coherent backscatter is left out (B_C0 = 0) and the porosity factor K is 1.
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

    /// <summary>Single-scattering albedo w.</summary>
    public double SingleScatteringAlbedo { get; }

    /// <summary>Width parameter b of the Henyey-Greenstein lobes.</summary>
    public double LobeWidth { get; }

    /// <summary>Weight c of the backward lobe, -1 to 1.</summary>
    public double BackwardWeight { get; }

    /// <summary>Amplitude B0 of the opposition surge.</summary>
    public double SurgeAmplitude { get; }

    /// <summary>Width h of the opposition surge.</summary>
    public double SurgeWidth { get; }

    /// <summary>Mean slope theta-bar of the roughness, degrees.</summary>
    public double MeanSlopeDegrees { get; }
}
