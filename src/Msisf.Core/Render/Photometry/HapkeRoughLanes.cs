using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Photometry;

/// <summary>The steps of <see cref="HapkeLanes"/> for the roughness: the formulas of <see cref="HapkeRoughness"/>.</summary>
internal static class HapkeRoughLanes
{
    /// <summary>The least square of a sine whose inverse is taken, so that the inverse is large and not undefined.</summary>
    private const double TinySquare = 1e-200;

    /// <summary>The squares of the sines of the incidence and emission angles, for their inverse roots.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be shaded with unoptimised vectors
    public static void SquareSines(
        ref Vector512<double> places, ref Vector512<double> cosIncidence, ref Vector512<double> cosEmission, int count)
    {
        Vector512<double> tiny = Vector512.Create(TinySquare);
        for (int i = 0; i < count; i++)
        {
            ref Vector512<double> at = ref Unsafe.Add(ref places, i);
            Unsafe.Add(ref at, HapkePlaces.PerSunSine) =
                Vector512.MaxNative(SquaredSine(Held(Unsafe.Add(ref cosIncidence, i))), tiny);
            Unsafe.Add(ref at, HapkePlaces.PerViewerSine) =
                Vector512.MaxNative(SquaredSine(Held(Unsafe.Add(ref cosEmission, i))), tiny);
        }
    }

    /// <summary>The azimuth between both directions, and the exponents that follow from the directions.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static void FindDirections(
        in HapkeLanes law,
        ref Vector512<double> places,
        ref Vector512<double> cosIncidence,
        ref Vector512<double> cosEmission,
        ref Vector512<double> phaseHaversine,
        int count)
    {
        Vector512<double> zero = Vector512<double>.Zero;
        Vector512<double> one = Vector512<double>.One;
        Vector512<double> perPi = Vector512.Create(-1.0 / Math.PI);
        Vector512<double> cotangent = law.Cotangent;
        for (int i = 0; i < count; i++)
        {
            ref Vector512<double> at = ref Unsafe.Add(ref places, i);
            Vector512<double> sun = Held(Unsafe.Add(ref cosIncidence, i));
            Vector512<double> viewer = Held(Unsafe.Add(ref cosEmission, i));
            Vector512<double> perSunSine = Unsafe.Add(ref at, HapkePlaces.PerSunSine);
            Vector512<double> perViewerSine = Unsafe.Add(ref at, HapkePlaces.PerViewerSine);
            Vector512<double> sunSine = Vector512.Sqrt(SquaredSine(sun));
            Vector512<double> viewerSine = Vector512.Sqrt(SquaredSine(viewer));

            // The azimuth as HapkeRoughness has it, to the last bit, since near 0 and pi it depends on every rounding. A quotient that is
            // corrected by its own rest is the one that a division gives (P. Markstein, IBM J. Res. Dev. 34 (1990), p. 111).
            Vector512<double> product = sunSine * viewerSine;
            Vector512<double> meridian = Vector512.Create(0.5) * (one - (sun * viewer) - product);
            Vector512<double> part = Unsafe.Add(ref phaseHaversine, i) - meridian;
            Vector512<double> perProduct = perSunSine * perViewerSine;
            Vector512<double> quotient = part * perProduct;
            quotient = Vector512.FusedMultiplyAdd(Vector512.FusedMultiplyAdd(-quotient, product, part), perProduct, quotient);
            Unsafe.Add(ref at, HapkePlaces.Azimuth) = Vector512.ConditionalSelect(
                Vector512.GreaterThan(product, zero), Vector512.MinNative(Vector512.MaxNative(quotient, zero), one), zero);

            Unsafe.Add(ref at, HapkePlaces.LowerSine) = Vector512.MaxNative(sunSine, viewerSine);
            Unsafe.Add(ref at, HapkePlaces.UpperSine) = Vector512.MinNative(sunSine, viewerSine);
            Vector512<double> lower = cotangent * (Vector512.MinNative(sun, viewer) * Vector512.MinNative(perSunSine, perViewerSine));
            Vector512<double> upper = cotangent * (Vector512.MaxNative(sun, viewer) * Vector512.MaxNative(perSunSine, perViewerSine));
            Unsafe.Add(ref at, HapkePlaces.LowerE1) = (perPi + perPi) * lower;
            Unsafe.Add(ref at, HapkePlaces.LowerE2) = perPi * lower * lower;
            Unsafe.Add(ref at, HapkePlaces.UpperE1) = (perPi + perPi) * upper;
            Unsafe.Add(ref at, HapkePlaces.UpperE2) = perPi * upper * upper;
        }
    }

    /// <summary>The exponent that follows from the azimuth, and sine times cosine of half the azimuth.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static void FindAzimuths(ref Vector512<double> places, int count)
    {
        Vector512<double> one = Vector512<double>.One;
        for (int i = 0; i < count; i++)
        {
            ref Vector512<double> at = ref Unsafe.Add(ref places, i);
            Vector512<double> azimuth = Unsafe.Add(ref at, HapkePlaces.Azimuth);
            Vector512<double> product = azimuth * (one - azimuth);
            Vector512<double> perRoot = LaneMath.InverseSqrt(Vector512.MaxNative(product, Vector512.Create(TinySquare)));
            Unsafe.Add(ref at, HapkePlaces.Hidden) = Vector512.Create(-2.0) * (azimuth * perRoot);
            Unsafe.Add(ref at, HapkePlaces.AzimuthOverPi) = Vector512.Create(2.0 / Math.PI) * (product * perRoot);
        }
    }

    /// <summary>The azimuth as an angle, from both sides.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static void FindAngles(ref Vector512<double> places, int count)
    {
        Vector512<double> one = Vector512<double>.One;
        for (int i = 0; i < count; i++)
        {
            ref Vector512<double> at = ref Unsafe.Add(ref places, i);
            Vector512<double> azimuth = Unsafe.Add(ref at, HapkePlaces.Azimuth);
            Vector512<double> rest = one - azimuth;
            Vector512<double> smallAngle = Unsafe.Add(ref at, HapkePlaces.AzimuthOverPi)
                * LaneMath.ArcsinOverSineCosine(Vector512.MinNative(azimuth, rest));
            Vector512<double> isSmall = Vector512.LessThanOrEqual(azimuth, rest);
            Vector512<double> largeAngle = one - smallAngle;
            Unsafe.Add(ref at, HapkePlaces.AzimuthOverPi) = Vector512.ConditionalSelect(isSmall, smallAngle, largeAngle);
            Unsafe.Add(ref at, HapkePlaces.AzimuthFromBehind) = Vector512.ConditionalSelect(isSmall, largeAngle, smallAngle);
        }
    }

    /// <summary>The effective cosines, and the denominator of the shadowing.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static void FindEffectiveCosines(
        in HapkeLanes law, ref Vector512<double> places, ref Vector512<double> cosIncidence, ref Vector512<double> cosEmission, int count)
    {
        Vector512<double> one = Vector512<double>.One;
        Vector512<double> chi = law.Chi;
        Vector512<double> tangent = law.Tangent;
        for (int i = 0; i < count; i++)
        {
            ref Vector512<double> at = ref Unsafe.Add(ref places, i);
            Vector512<double> sun = Held(Unsafe.Add(ref cosIncidence, i));
            Vector512<double> viewer = Held(Unsafe.Add(ref cosEmission, i));
            Vector512<double> lowerCosine = Vector512.MinNative(sun, viewer);
            Vector512<double> upperCosine = Vector512.MaxNative(sun, viewer);
            Vector512<double> azimuth = Unsafe.Add(ref at, HapkePlaces.Azimuth);
            Vector512<double> rest = one - azimuth;
            Vector512<double> lowerE1 = Unsafe.Add(ref at, HapkePlaces.LowerE1);
            Vector512<double> upperE1 = Unsafe.Add(ref at, HapkePlaces.UpperE1);
            Vector512<double> lowerE2 = one + Unsafe.Add(ref at, HapkePlaces.LowerE2);
            Vector512<double> upperE2 = one + Unsafe.Add(ref at, HapkePlaces.UpperE2);

            // Three quotients with one division.
            Vector512<double> lowerRest = one - lowerE1;
            Vector512<double> upperRest = one - upperE1;
            Vector512<double> bothRest = Unsafe.Add(ref at, HapkePlaces.AzimuthFromBehind) - lowerE1
                - (Unsafe.Add(ref at, HapkePlaces.AzimuthOverPi) * upperE1);
            Vector512<double> restProduct = lowerRest * upperRest;
            Vector512<double> tangentPerAll = tangent / (restProduct * bothRest);
            Vector512<double> lowerSlope = Unsafe.Add(ref at, HapkePlaces.LowerSine) * tangentPerAll;
            Vector512<double> upperSlope = Unsafe.Add(ref at, HapkePlaces.UpperSine) * tangentPerAll;
            Vector512<double> lowerEta = chi * (lowerCosine + (lowerSlope * (upperRest * bothRest) * lowerE2));
            Vector512<double> upperEta = chi * (upperCosine + (upperSlope * (lowerRest * bothRest) * upperE2));
            Vector512<double> between = Unsafe.Add(ref at, HapkePlaces.LowerE2) - Unsafe.Add(ref at, HapkePlaces.UpperE2);
            Vector512<double> hidden = Unsafe.Add(ref at, HapkePlaces.Hidden);
            Unsafe.Add(ref at, HapkePlaces.Lower) =
                chi * (lowerCosine + (lowerSlope * restProduct * ((rest * upperE2) + between)));
            Unsafe.Add(ref at, HapkePlaces.Upper) =
                chi * (upperCosine + (upperSlope * restProduct * ((rest * lowerE2) - (azimuth * between))));
            Unsafe.Add(ref at, HapkePlaces.Shadowed) =
                lowerEta * (((one + hidden) * chi * upperCosine) - (upperEta * hidden));
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Held(Vector512<double> cosine) =>
        Vector512.MaxNative(cosine, Vector512.Create(Tolerances.GrazingCosine));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> SquaredSine(Vector512<double> cosine) =>
        (Vector512<double>.One - cosine) * (Vector512<double>.One + cosine);
}
