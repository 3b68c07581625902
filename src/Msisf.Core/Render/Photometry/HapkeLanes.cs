using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Hapke's law for eight points at once, each with its own parameters. It agrees with <see cref="HapkeReflectance"/> to 1e-12, and is
/// rearranged so that few divisions and roots are left.
/// </summary>
internal readonly struct HapkeLanes
{
    /// <summary>Added to sines of 0, so that quotients by them are large and not undefined.</summary>
    private const double TinySine = 1e-100;

    private readonly Vector512<double> _scale;
    private readonly Vector512<double> _w;
    private readonly Vector512<double> _r0;
    private readonly Vector512<double> _lobeWidth;
    private readonly Vector512<double> _backward;
    private readonly Vector512<double> _forward;
    private readonly Vector512<double> _surgeAmplitude;
    private readonly Vector512<double> _surgeWidth;
    private readonly Vector512<double> _tangent;
    private readonly Vector512<double> _cotangent;
    private readonly Vector512<double> _chi;

    /// <summary>Takes the parameters of eight points.</summary>
    /// <param name="scale">Factor of the radiance factors.</param>
    /// <param name="w">Single-scattering albedo.</param>
    /// <param name="b">Width of the Henyey-Greenstein lobes.</param>
    /// <param name="c">Weight of the backward lobe.</param>
    /// <param name="surgeAmplitude">B0.</param>
    /// <param name="surgeWidth">h.</param>
    /// <param name="slopeTangent">Tangent of the mean slope; 0 for a smooth surface.</param>
    public HapkeLanes(
        Vector512<double> scale, Vector512<double> w, Vector512<double> b, Vector512<double> c, Vector512<double> surgeAmplitude,
        Vector512<double> surgeWidth, Vector512<double> slopeTangent)
    {
        Vector512<double> one = Vector512<double>.One;
        Vector512<double> gamma = Vector512.Sqrt(one - w);
        Vector512<double> lobe = Vector512.Create(0.5) * (one - (b * b));
        Vector512<double> roughness = one + (Vector512.Create(Math.PI) * slopeTangent * slopeTangent);
        _w = w;
        _r0 = (one - gamma) / (one + gamma);
        _lobeWidth = b;
        _backward = lobe * (one + c);
        _forward = lobe * (one - c);
        _surgeAmplitude = surgeAmplitude;
        _surgeWidth = surgeWidth;
        _tangent = slopeTangent;
        _cotangent = one / slopeTangent;
        _chi = one / Vector512.Sqrt(roughness);
        _scale = scale * Vector512.Create(0.25) * w * _chi;
    }

    /// <summary>Radiance factors; 0 where a cosine is not above 0.</summary>
    /// <param name="law">The parameters.</param>
    /// <param name="cosIncidence">Cosines of the incidence angles, up to 1.</param>
    /// <param name="cosEmission">Cosines of the emission angles, up to 1.</param>
    /// <param name="phaseHaversine">sin^2 of half the phase angles, 0 to 1.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would else be shaded with unoptimised vectors
    public static Vector512<double> RadianceFactors(
        in HapkeLanes law, Vector512<double> cosIncidence, Vector512<double> cosEmission, Vector512<double> phaseHaversine)
    {
        Vector512<double> zero = Vector512<double>.Zero;
        Vector512<double> one = Vector512<double>.One;
        Vector512<double> grazing = Vector512.Create(Tolerances.GrazingCosine);
        Vector512<double> sun = Vector512.MaxNative(cosIncidence, grazing);
        Vector512<double> viewer = Vector512.MaxNative(cosEmission, grazing);
        Vector512<double> sunSine = Vector512.Sqrt((one - sun) * (one + sun));
        Vector512<double> viewerSine = Vector512.Sqrt((one - viewer) * (one + viewer));

        // The azimuth as HapkeRoughness has it, operation by operation: near 0 and pi it depends on every rounding.
        Vector512<double> product = sunSine * viewerSine;
        Vector512<double> meridian = Vector512.Create(0.5) * (one - (sun * viewer) - product);
        Vector512<double> quotient = (phaseHaversine - meridian) / product;
        Vector512<double> azimuth = Vector512.ConditionalSelect(
            Vector512.GreaterThan(product, zero), Vector512.MinNative(Vector512.MaxNative(quotient, zero), one), zero);
        Vector512<double> rest = one - azimuth;
        Vector512<double> azimuthSine = Vector512.Sqrt(azimuth);
        Vector512<double> azimuthCosine = Vector512.Sqrt(rest);
        Vector512<double> small = Vector512.MinNative(azimuth, rest);
        Vector512<double> smallAngle = Vector512.Create(2.0 / Math.PI) * Vector512.MinNative(azimuthSine, azimuthCosine)
            * LaneMath.ArcsinOverSine(small);
        Vector512<double> azimuthOverPi = Vector512.ConditionalSelect(
            Vector512.LessThanOrEqual(azimuth, rest), smallAngle, one - smallAngle);
        Vector512<double> hidden = LaneMath.ExpOfNegative(
            Vector512.Create(-2.0) * (azimuthSine / Vector512.MaxNative(azimuthCosine, Vector512.Create(TinySine))));

        // Cotangents of both zenith distances with one division.
        Vector512<double> sunSafe = Vector512.MaxNative(sunSine, Vector512.Create(TinySine));
        Vector512<double> viewerSafe = Vector512.MaxNative(viewerSine, Vector512.Create(TinySine));
        Vector512<double> perSines = law._cotangent / (sunSafe * viewerSafe);
        Vector512<double> lowerCosine = Vector512.MinNative(sun, viewer);
        Vector512<double> upperCosine = Vector512.MaxNative(sun, viewer);
        Vector512<double> lowerSine = Vector512.MaxNative(sunSafe, viewerSafe);
        Vector512<double> upperSine = Vector512.MinNative(sunSafe, viewerSafe);
        Vector512<double> lowerRatio = lowerCosine * upperSine * perSines;
        Vector512<double> upperRatio = upperCosine * lowerSine * perSines;
        Vector512<double> perPi = Vector512.Create(-1.0 / Math.PI);
        Vector512<double> lowerE1 = LaneMath.ExpOfNegative((perPi + perPi) * lowerRatio);
        Vector512<double> upperE1 = LaneMath.ExpOfNegative((perPi + perPi) * upperRatio);
        Vector512<double> lowerE2 = LaneMath.ExpOfNegative(perPi * lowerRatio * lowerRatio);
        Vector512<double> upperE2 = LaneMath.ExpOfNegative(perPi * upperRatio * upperRatio);

        // Three quotients with one division.
        Vector512<double> lowerRest = one + one - lowerE1;
        Vector512<double> upperRest = one + one - upperE1;
        Vector512<double> bothRest = lowerRest - (azimuthOverPi * upperE1);
        Vector512<double> tangentPerAll = law._tangent / (lowerRest * upperRest * bothRest);
        Vector512<double> lowerSlope = lowerSine * tangentPerAll;
        Vector512<double> upperSlope = upperSine * tangentPerAll;
        Vector512<double> lowerEta = law._chi * (lowerCosine + (lowerSlope * (upperRest * bothRest) * lowerE2));
        Vector512<double> upperEta = law._chi * (upperCosine + (upperSlope * (lowerRest * bothRest) * upperE2));
        Vector512<double> restProduct = lowerRest * upperRest;
        Vector512<double> lower = law._chi * (lowerCosine + (lowerSlope * restProduct * (lowerE2 - (azimuth * upperE2))));
        Vector512<double> upper = law._chi
            * (upperCosine + (upperSlope * restProduct * (((one - (azimuth + azimuth)) * lowerE2) + (azimuth * upperE2))));
        Vector512<double> shadowed = lowerEta * ((upperEta * (one - hidden)) + (hidden * law._chi * upperCosine));

        Single(law, phaseHaversine, out Vector512<double> single, out Vector512<double> perSingle);
        LaneMath.LogOfOnePlusInverse(lower, upper, out Vector512<double> lowerLog, out Vector512<double> upperLog);
        Vector512<double> absorbed = Absorbed(law, lower, lowerLog) * Absorbed(law, upper, upperLog);
        Vector512<double> numerator = lower * upper * sun * ((single * absorbed) + (perSingle * (one - absorbed)));
        Vector512<double> factors = law._scale * numerator / ((lower + upper) * shadowed * (perSingle * absorbed));
        Vector512<double> isSeen = Vector512.GreaterThan(Vector512.MinNative(cosIncidence, cosEmission), zero);
        return factors & isSeen;
    }

    /// <summary>Single scattering with its opposition surge, p(g) (1 + B(g)), as a numerator and a denominator.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Single(
        in HapkeLanes law, Vector512<double> phaseHaversine, out Vector512<double> numerator, out Vector512<double> denominator)
    {
        Vector512<double> one = Vector512<double>.One;
        Vector512<double> rest = one - phaseHaversine;
        Vector512<double> nearest = (one - law._lobeWidth) * (one - law._lobeWidth);
        Vector512<double> fourWidths = Vector512.Create(4.0) * law._lobeWidth;
        Vector512<double> backward = nearest + (fourWidths * phaseHaversine);
        Vector512<double> forward = nearest + (fourWidths * rest);
        backward *= Vector512.Sqrt(backward);
        forward *= Vector512.Sqrt(forward);
        Vector512<double> width = law._surgeWidth * Vector512.Sqrt(rest);
        Vector512<double> sum = width + Vector512.Sqrt(phaseHaversine);
        numerator = ((law._backward * forward) + (law._forward * backward)) * (sum + (law._surgeAmplitude * width));
        denominator = backward * forward * sum;
    }

    /// <summary>The inverse of the function H(x) of multiple scattering.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Absorbed(in HapkeLanes law, Vector512<double> x, Vector512<double> logOfOnePlusInverse) =>
        Vector512<double>.One
            - (law._w * x * (law._r0 + ((Vector512.Create(0.5) - (law._r0 * x)) * logOfOnePlusInverse)));
}
