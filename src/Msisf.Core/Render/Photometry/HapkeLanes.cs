using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Hapke's law for eight points at once, each with its own parameters, or for many with the same. It agrees with
/// <see cref="HapkeReflectance"/> to 1e-12, and is rearranged so that few divisions and roots are left. It is computed in steps, each for a
/// block of points: in one step for all, each operation would wait for the one before it.
/// </summary>
internal readonly struct HapkeLanes
{
    /// <summary>Added to sines of 0, so that quotients by them are large and not undefined.</summary>
    private const double TinySine = 1e-100;

    /// <summary>Length of the memory that <see cref="BufferIn"/> needs.</summary>
    public const int BufferLength = (Quantities * Block * 8) + 8;

    /// <summary>Vectors of a block: with its buffer it stays in the fastest memory.</summary>
    private const int Block = 8;

    /// <summary>Quantities that are kept from step to step.</summary>
    private const int Quantities = 12;

    // Places of the quantities in the buffer; a later one takes the place of one that is no longer needed.
    private const int LowerCosine = 0 * Block;
    private const int UpperCosine = 1 * Block;
    private const int LowerSine = 2 * Block;
    private const int UpperSine = 3 * Block;
    private const int Azimuth = 4 * Block;
    private const int AzimuthOverPi = 5 * Block;
    private const int AzimuthFromBehind = 6 * Block;
    private const int Hidden = 7 * Block;
    private const int LowerE1 = 8 * Block; // first the quotient of the cotangents of zenith distance and slope, then E1 - 1
    private const int UpperE1 = 9 * Block;
    private const int LowerE2 = 10 * Block;
    private const int UpperE2 = 11 * Block;
    private const int Lower = LowerCosine;
    private const int Upper = UpperCosine;
    private const int Shadowed = LowerSine;

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

    /// <summary>
    /// A buffer for the computation, which begins where a line of the cache does, so that no vector lies across two lines.
    /// </summary>
    /// <param name="stack">Memory on the stack, which does not move, of <see cref="BufferLength"/>.</param>
    public static Span<Vector512<double>> BufferIn(Span<double> stack)
    {
        long address = Unsafe.ByteOffset(ref Unsafe.NullRef<double>(), ref MemoryMarshal.GetReference(stack));
        int toNextLine = (int)((-address / sizeof(double)) & (Vector512<double>.Count - 1));
        return MemoryMarshal.Cast<double, Vector512<double>>(stack[toNextLine..]);
    }

    /// <summary>Computes radiance factors; 0 where a cosine is not above 0.</summary>
    /// <param name="law">The parameters.</param>
    /// <param name="cosIncidence">Cosines of the incidence angles, up to 1.</param>
    /// <param name="cosEmission">Cosines of the emission angles, up to 1.</param>
    /// <param name="phaseHaversine">sin^2 of half the phase angles, 0 to 1.</param>
    /// <param name="factors">Receives the radiance factors.</param>
    /// <param name="buffer">From <see cref="BufferIn"/>; its content does not matter.</param>
    public static void RadianceFactors(
        in HapkeLanes law,
        ReadOnlySpan<Vector512<double>> cosIncidence,
        ReadOnlySpan<Vector512<double>> cosEmission,
        ReadOnlySpan<Vector512<double>> phaseHaversine,
        Span<Vector512<double>> factors,
        Span<Vector512<double>> buffer)
    {
        for (int start = 0; start < factors.Length; start += Block)
        {
            int count = Math.Min(Block, factors.Length - start);
            ReadOnlySpan<Vector512<double>> incidence = cosIncidence.Slice(start, count);
            ReadOnlySpan<Vector512<double>> emission = cosEmission.Slice(start, count);
            ReadOnlySpan<Vector512<double>> phase = phaseHaversine.Slice(start, count);
            FindDirections(law, incidence, emission, phase, buffer);
            FindAzimuths(buffer, count);
            FindExponentials(buffer, count);
            FindEffectiveCosines(law, buffer, count);
            Reflect(law, incidence, emission, phase, buffer, factors.Slice(start, count));
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would else be shaded with unoptimised vectors
    private static void FindDirections(
        in HapkeLanes law,
        ReadOnlySpan<Vector512<double>> cosIncidence,
        ReadOnlySpan<Vector512<double>> cosEmission,
        ReadOnlySpan<Vector512<double>> phaseHaversine,
        Span<Vector512<double>> buffer)
    {
        Vector512<double> zero = Vector512<double>.Zero;
        Vector512<double> one = Vector512<double>.One;
        Vector512<double> grazing = Vector512.Create(Tolerances.GrazingCosine);
        Vector512<double> tiny = Vector512.Create(TinySine);
        Vector512<double> cotangent = law._cotangent;
        for (int i = 0; i < cosIncidence.Length; i++)
        {
            Vector512<double> sun = Vector512.MaxNative(cosIncidence[i], grazing);
            Vector512<double> viewer = Vector512.MaxNative(cosEmission[i], grazing);
            Vector512<double> sunSine = Vector512.Sqrt((one - sun) * (one + sun));
            Vector512<double> viewerSine = Vector512.Sqrt((one - viewer) * (one + viewer));

            // The azimuth as HapkeRoughness has it, to the last bit, since near 0 and pi it depends on every rounding. A quotient that is
            // corrected by its own rest is the one that a division gives (P. Markstein, IBM J. Res. Dev. 34 (1990), p. 111).
            Vector512<double> product = sunSine * viewerSine;
            Vector512<double> meridian = Vector512.Create(0.5) * (one - (sun * viewer) - product);
            Vector512<double> part = phaseHaversine[i] - meridian;
            Vector512<double> sunSafe = Vector512.MaxNative(sunSine, tiny);
            Vector512<double> viewerSafe = Vector512.MaxNative(viewerSine, tiny);
            Vector512<double> perProduct = one / (sunSafe * viewerSafe);
            Vector512<double> quotient = part * perProduct;
            quotient = Vector512.FusedMultiplyAdd(Vector512.FusedMultiplyAdd(-quotient, product, part), perProduct, quotient);
            buffer[Azimuth + i] = Vector512.ConditionalSelect(
                Vector512.GreaterThan(product, zero), Vector512.MinNative(Vector512.MaxNative(quotient, zero), one), zero);

            Vector512<double> perSines = cotangent * perProduct;
            Vector512<double> lowerCosine = Vector512.MinNative(sun, viewer);
            Vector512<double> upperCosine = Vector512.MaxNative(sun, viewer);
            Vector512<double> lowerSine = Vector512.MaxNative(sunSafe, viewerSafe);
            Vector512<double> upperSine = Vector512.MinNative(sunSafe, viewerSafe);
            buffer[LowerCosine + i] = lowerCosine;
            buffer[UpperCosine + i] = upperCosine;
            buffer[LowerSine + i] = lowerSine;
            buffer[UpperSine + i] = upperSine;
            buffer[LowerE1 + i] = lowerCosine * upperSine * perSines;
            buffer[UpperE1 + i] = upperCosine * lowerSine * perSines;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void FindAzimuths(Span<Vector512<double>> buffer, int count)
    {
        Vector512<double> one = Vector512<double>.One;
        for (int i = 0; i < count; i++)
        {
            Vector512<double> azimuth = buffer[Azimuth + i];
            Vector512<double> rest = one - azimuth;
            Vector512<double> product = azimuth * rest;
            Vector512<double> perRoot = LaneMath.InverseSqrt(Vector512.MaxNative(product, Vector512.Create(TinySine * TinySine)));
            Vector512<double> smallAngle = Vector512.Create(2.0 / Math.PI) * (product * perRoot)
                * LaneMath.ArcsinOverSineCosine(Vector512.MinNative(azimuth, rest));
            Vector512<double> isSmall = Vector512.LessThanOrEqual(azimuth, rest);
            buffer[AzimuthOverPi + i] = Vector512.ConditionalSelect(isSmall, smallAngle, one - smallAngle);
            buffer[AzimuthFromBehind + i] = Vector512.ConditionalSelect(isSmall, one - smallAngle, smallAngle);
            buffer[Hidden + i] = LaneMath.ExpMinusOne(Vector512.Create(-2.0) * (azimuth * perRoot));
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void FindExponentials(Span<Vector512<double>> buffer, int count)
    {
        Vector512<double> perPi = Vector512.Create(-1.0 / Math.PI);
        for (int i = 0; i < count; i++)
        {
            Vector512<double> ratio = buffer[LowerE1 + i];
            buffer[LowerE1 + i] = LaneMath.ExpMinusOne((perPi + perPi) * ratio);
            buffer[LowerE2 + i] = LaneMath.ExpMinusOne(perPi * ratio * ratio);
        }

        for (int i = 0; i < count; i++)
        {
            Vector512<double> ratio = buffer[UpperE1 + i];
            buffer[UpperE1 + i] = LaneMath.ExpMinusOne((perPi + perPi) * ratio);
            buffer[UpperE2 + i] = LaneMath.ExpMinusOne(perPi * ratio * ratio);
        }
    }

    /// <summary>The formulas of <see cref="HapkeRoughness"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void FindEffectiveCosines(in HapkeLanes law, Span<Vector512<double>> buffer, int count)
    {
        Vector512<double> one = Vector512<double>.One;
        for (int i = 0; i < count; i++)
        {
            Vector512<double> lowerCosine = buffer[LowerCosine + i];
            Vector512<double> upperCosine = buffer[UpperCosine + i];
            Vector512<double> azimuth = buffer[Azimuth + i];
            Vector512<double> rest = one - azimuth;
            Vector512<double> lowerE1 = buffer[LowerE1 + i];
            Vector512<double> upperE1 = buffer[UpperE1 + i];
            Vector512<double> lowerE2 = one + buffer[LowerE2 + i];
            Vector512<double> upperE2 = one + buffer[UpperE2 + i];

            // Three quotients with one division.
            Vector512<double> lowerRest = one - lowerE1;
            Vector512<double> upperRest = one - upperE1;
            Vector512<double> bothRest = buffer[AzimuthFromBehind + i] - lowerE1 - (buffer[AzimuthOverPi + i] * upperE1);
            Vector512<double> restProduct = lowerRest * upperRest;
            Vector512<double> tangentPerAll = law._tangent / (restProduct * bothRest);
            Vector512<double> lowerSlope = buffer[LowerSine + i] * tangentPerAll;
            Vector512<double> upperSlope = buffer[UpperSine + i] * tangentPerAll;
            Vector512<double> lowerEta = law._chi * (lowerCosine + (lowerSlope * (upperRest * bothRest) * lowerE2));
            Vector512<double> upperEta = law._chi * (upperCosine + (upperSlope * (lowerRest * bothRest) * upperE2));
            Vector512<double> between = buffer[LowerE2 + i] - buffer[UpperE2 + i];
            Vector512<double> hidden = buffer[Hidden + i];
            buffer[Lower + i] = law._chi * (lowerCosine + (lowerSlope * restProduct * ((rest * upperE2) + between)));
            buffer[Upper + i] = law._chi * (upperCosine + (upperSlope * restProduct * ((rest * lowerE2) - (azimuth * between))));
            buffer[Shadowed + i] = lowerEta * (((one + hidden) * law._chi * upperCosine) - (upperEta * hidden));
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void Reflect(
        in HapkeLanes law,
        ReadOnlySpan<Vector512<double>> cosIncidence,
        ReadOnlySpan<Vector512<double>> cosEmission,
        ReadOnlySpan<Vector512<double>> phaseHaversine,
        ReadOnlySpan<Vector512<double>> buffer,
        Span<Vector512<double>> factors)
    {
        Vector512<double> one = Vector512<double>.One;
        for (int i = 0; i < factors.Length; i++)
        {
            Vector512<double> lower = buffer[Lower + i];
            Vector512<double> upper = buffer[Upper + i];
            LaneMath.LogOfOnePlusInverse(lower, upper, out Vector512<double> lowerLog, out Vector512<double> upperLog);
            Vector512<double> absorbed = Absorbed(law, lower, lowerLog) * Absorbed(law, upper, upperLog);
            Single(law, phaseHaversine[i], out Vector512<double> single, out Vector512<double> perSingle);
            Vector512<double> sun = Vector512.MaxNative(cosIncidence[i], Vector512.Create(Tolerances.GrazingCosine));
            Vector512<double> numerator = lower * upper * sun * ((single * absorbed) + (perSingle * (one - absorbed)));
            Vector512<double> isSeen = Vector512.GreaterThan(
                Vector512.MinNative(cosIncidence[i], cosEmission[i]), Vector512<double>.Zero);
            factors[i] = isSeen
                & (law._scale * numerator / ((lower + upper) * buffer[Shadowed + i] * (perSingle * absorbed)));
        }
    }

    /// <summary>Single scattering with its opposition surge, p(g) (1 + B(g)), as a numerator and a denominator.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Single(
        in HapkeLanes law, Vector512<double> phaseHaversine, out Vector512<double> numerator, out Vector512<double> denominator)
    {
        Vector512<double> nearest = (Vector512<double>.One - law._lobeWidth) * (Vector512<double>.One - law._lobeWidth);
        Vector512<double> fourWidths = Vector512.Create(4.0) * law._lobeWidth;
        Vector512<double> rest = Vector512.MaxNative(Vector512<double>.One - phaseHaversine, Vector512.Create(TinySine));
        Vector512<double> backward = LaneMath.InverseSqrt(nearest + (fourWidths * phaseHaversine));
        Vector512<double> forward = LaneMath.InverseSqrt(nearest + (fourWidths * rest));
        Vector512<double> lobes = (law._backward * (backward * backward * backward)) + (law._forward * (forward * forward * forward));

        // h / (h + tan(g/2)), both times cos^2(g/2).
        Vector512<double> product = phaseHaversine * rest;
        Vector512<double> perRoot = LaneMath.InverseSqrt(Vector512.MaxNative(product, Vector512.Create(TinySine * TinySine)));
        Vector512<double> width = law._surgeWidth * rest;
        denominator = width + (product * perRoot);
        numerator = lobes * (denominator + (law._surgeAmplitude * width));
    }

    /// <summary>The inverse of the function H(x) of multiple scattering.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Absorbed(in HapkeLanes law, Vector512<double> x, Vector512<double> logOfOnePlusInverse) =>
        Vector512<double>.One
            - (law._w * x * (law._r0 + ((Vector512.Create(0.5) - (law._r0 * x)) * logOfOnePlusInverse)));
}
