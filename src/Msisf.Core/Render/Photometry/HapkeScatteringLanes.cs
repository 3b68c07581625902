using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Photometry;

/// <summary>The steps of <see cref="HapkeLanes"/> for single and multiple scattering, and the last one.</summary>
internal static class HapkeScatteringLanes
{
    /// <summary>Added to sines of 0, so that quotients by them are large and not undefined.</summary>
    private const double TinySine = 1e-100;

    /// <summary>The numbers whose inverse roots single scattering needs.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be shaded with unoptimised vectors
    public static void SquareLobes(in HapkeLanes law, ref Vector512<double> places, ref Vector512<double> phaseHaversine, int count)
    {
        Vector512<double> tiny = Vector512.Create(TinySine);
        Vector512<double> nearest = law.NearestLobe;
        Vector512<double> fourWidths = law.FourLobeWidths;
        for (int i = 0; i < count; i++)
        {
            ref Vector512<double> at = ref Unsafe.Add(ref places, i);
            Vector512<double> phase = Unsafe.Add(ref phaseHaversine, i);
            Vector512<double> rest = Vector512.MaxNative(Vector512<double>.One - phase, tiny);
            Unsafe.Add(ref at, HapkePlaces.Backward) = nearest + (fourWidths * phase);
            Unsafe.Add(ref at, HapkePlaces.Forward) = nearest + (fourWidths * rest);
            Unsafe.Add(ref at, HapkePlaces.PerPhaseSine) = Vector512.MaxNative(phase * rest, tiny * tiny);
        }
    }

    /// <summary>Single scattering with its opposition surge, p(g) (1 + B(g)), as a numerator and a denominator.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static void FindSingle(in HapkeLanes law, ref Vector512<double> places, ref Vector512<double> phaseHaversine, int count)
    {
        Vector512<double> tiny = Vector512.Create(TinySine);
        for (int i = 0; i < count; i++)
        {
            ref Vector512<double> at = ref Unsafe.Add(ref places, i);
            Vector512<double> backward = Unsafe.Add(ref at, HapkePlaces.Backward);
            Vector512<double> forward = Unsafe.Add(ref at, HapkePlaces.Forward);
            Vector512<double> lobes = (law.Backward * (backward * backward * backward)) + (law.Forward * (forward * forward * forward));

            // h / (h + tan(g/2)), both times cos^2(g/2).
            Vector512<double> phase = Unsafe.Add(ref phaseHaversine, i);
            Vector512<double> rest = Vector512.MaxNative(Vector512<double>.One - phase, tiny);
            Vector512<double> width = law.SurgeWidth * rest;
            Vector512<double> denominator = width + (phase * rest * Unsafe.Add(ref at, HapkePlaces.PerPhaseSine));
            Unsafe.Add(ref at, HapkePlaces.Single) = lobes * (denominator + (law.SurgeAmplitude * width));
            Unsafe.Add(ref at, HapkePlaces.PerSingle) = denominator;
        }
    }

    /// <summary>The parts of the logarithms in the function H of multiple scattering.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static void SplitCosines(ref Vector512<double> places, int count)
    {
        for (int i = 0; i < count; i++)
        {
            ref Vector512<double> at = ref Unsafe.Add(ref places, i);
            LaneMath.SplitOnePlusInverse(
                Unsafe.Add(ref at, HapkePlaces.Lower), Unsafe.Add(ref at, HapkePlaces.Upper),
                out Unsafe.Add(ref at, HapkePlaces.LowerExponent), out Unsafe.Add(ref at, HapkePlaces.UpperExponent),
                out Unsafe.Add(ref at, HapkePlaces.LowerRest), out Unsafe.Add(ref at, HapkePlaces.UpperRest));
        }
    }

    /// <summary>The inverses of the function H of multiple scattering, multiplied.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static void FindAbsorbed(in HapkeLanes law, ref Vector512<double> places, int count)
    {
        Vector512<double> w = law.W;
        Vector512<double> r0 = law.R0;
        for (int i = 0; i < count; i++)
        {
            ref Vector512<double> at = ref Unsafe.Add(ref places, i);
            Vector512<double> lowerLog = LaneMath.LogOf(
                Unsafe.Add(ref at, HapkePlaces.LowerExponent), Unsafe.Add(ref at, HapkePlaces.LowerRest));
            Vector512<double> upperLog = LaneMath.LogOf(
                Unsafe.Add(ref at, HapkePlaces.UpperExponent), Unsafe.Add(ref at, HapkePlaces.UpperRest));
            Unsafe.Add(ref at, HapkePlaces.Absorbed) =
                Absorbed(w, r0, Unsafe.Add(ref at, HapkePlaces.Lower), lowerLog)
                * Absorbed(w, r0, Unsafe.Add(ref at, HapkePlaces.Upper), upperLog);
        }
    }

    /// <summary>The radiance factors.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static void Reflect(
        in HapkeLanes law,
        ref Vector512<double> places,
        ref Vector512<double> cosIncidence,
        ref Vector512<double> cosEmission,
        ref Vector512<double> factors,
        int count)
    {
        Vector512<double> one = Vector512<double>.One;
        for (int i = 0; i < count; i++)
        {
            ref Vector512<double> at = ref Unsafe.Add(ref places, i);
            Vector512<double> lower = Unsafe.Add(ref at, HapkePlaces.Lower);
            Vector512<double> upper = Unsafe.Add(ref at, HapkePlaces.Upper);
            Vector512<double> absorbed = Unsafe.Add(ref at, HapkePlaces.Absorbed);
            Vector512<double> single = Unsafe.Add(ref at, HapkePlaces.Single);
            Vector512<double> perSingle = Unsafe.Add(ref at, HapkePlaces.PerSingle);
            Vector512<double> cosine = Unsafe.Add(ref cosIncidence, i);
            Vector512<double> sun = Vector512.MaxNative(cosine, Vector512.Create(Tolerances.GrazingCosine));
            Vector512<double> numerator = lower * upper * sun * ((single * absorbed) + (perSingle * (one - absorbed)));
            Vector512<double> isSeen = Vector512.GreaterThan(
                Vector512.MinNative(cosine, Unsafe.Add(ref cosEmission, i)), Vector512<double>.Zero);
            Vector512<double> denominator =
                (lower + upper) * Unsafe.Add(ref at, HapkePlaces.Shadowed) * (perSingle * absorbed);
            Unsafe.Add(ref factors, i) = isSeen & (law.Scale * numerator / denominator);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Absorbed(
        Vector512<double> w, Vector512<double> r0, Vector512<double> x, Vector512<double> logOfOnePlusInverse) =>
        Vector512<double>.One - (w * x * (r0 + ((Vector512.Create(0.5) - (r0 * x)) * logOfOnePlusInverse)));
}
