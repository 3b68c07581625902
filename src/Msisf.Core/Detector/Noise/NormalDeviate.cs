using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Detector.Noise;

/// <summary>
/// Normal deviates of mean 0 and standard deviation 1: the inverse of the normal distribution at a uniform number, to 16 digits. Made of
/// exact operations only, so every machine gets the same bits.
/// </summary>
/// <remarks>
/// M. J. Wichura, "Algorithm AS 241: the percentage points of the normal distribution", Applied Statistics 37 (1988), PPND16.
/// </remarks>
internal static class NormalDeviate
{
    private const double CentralRange = 0.425;
    private const double CentralConstant = 0.180625;
    private const double TailRange = 5.0;
    private const double NearTailOffset = 1.6;

    /// <summary>One deviate of each pixel of a part of a row.</summary>
    /// <param name="noise">Source of the random numbers.</param>
    /// <param name="kind">What they are for.</param>
    /// <param name="first">Index of the first pixel.</param>
    /// <param name="deviates">Receives the deviates, at most <see cref="NoiseSource.MaxRun"/>.</param>
    public static void Fill(in NoiseSource noise, NoiseKind kind, uint first, Span<double> deviates)
    {
        Span<double> probabilities = stackalloc double[deviates.Length];
        noise.Fill(kind, first, probabilities);
        OfProbabilities(probabilities, deviates);
    }

    /// <summary>The deviates below which parts of the distribution lie.</summary>
    /// <param name="probabilities">Between 0 and 1, without both ends; at most <see cref="NoiseSource.MaxRun"/>.</param>
    /// <param name="deviates">Receives as many deviates.</param>
    public static void OfProbabilities(ReadOnlySpan<double> probabilities, Span<double> deviates)
    {
        Span<double> padded = stackalloc double[NoiseSource.MaxRun + NoiseSource.Lanes];
        padded[probabilities.Length..].Fill(0.5);
        probabilities.CopyTo(padded);
        Span<int> tails = stackalloc int[NoiseSource.MaxRun + NoiseSource.Lanes];
        int count = 0;
        for (int start = 0; start < deviates.Length; start += NoiseSource.Lanes)
        {
            Vector256<double> fromMiddle = LaneBuffer.Load(padded, start) - Vector256.Create(0.5);
            Vector256<double> r = Vector256.Create(CentralConstant) - (fromMiddle * fromMiddle);
            LaneBuffer.Store(
                fromMiddle * CentralAbove(r) / CentralBelow(r), deviates, start);
            uint isTail = Vector256.GreaterThan(
                Vector256.Abs(fromMiddle), Vector256.Create(CentralRange)).ExtractMostSignificantBits();
            count = LaneBuffer.Append(tails, count, start, isTail);
        }

        FillTails(padded, tails, count, deviates);
    }

    private static void FillTails(ReadOnlySpan<double> probabilities, Span<int> tails, int count, Span<double> deviates)
    {
        tails.Slice(count, NoiseSource.Lanes).Fill(tails[0]); // pads the last four places
        for (int start = 0; start < count; start += NoiseSource.Lanes)
        {
            (int p0, int p1, int p2, int p3) = (tails[start], tails[start + 1], tails[start + 2], tails[start + 3]);
            Vector256<double> deviate = Tail(
                Vector256.Create(probabilities[p0], probabilities[p1], probabilities[p2], probabilities[p3]));
            deviates[p0] = deviate[0];
            deviates[p1] = deviate[1];
            deviates[p2] = deviate[2];
            deviates[p3] = deviate[3];
        }
    }

    private static Vector256<double> Tail(Vector256<double> probability)
    {
        Vector256<double> outside = Vector256.Min(probability, Vector256<double>.One - probability);
        Vector256<double> r = Vector256.Sqrt(-PortableLanes.Log(outside));
        Vector256<double> near = r - Vector256.Create(NearTailOffset);
        Vector256<double> far = r - Vector256.Create(TailRange);
        Vector256<double> deviate = Vector256.ConditionalSelect(
            Vector256.LessThanOrEqual(r, Vector256.Create(TailRange)),
            NearAbove(near) / NearBelow(near),
            FarAbove(far) / FarBelow(far));
        return Vector256.ConditionalSelect(Vector256.LessThan(probability, Vector256.Create(0.5)), -deviate, deviate);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> CentralAbove(Vector256<double> x) => PortableLanes.Polynomial(
        x, 2509.0809287301226727, 33430.575583588128105, 67265.770927008700853, 45921.953931549871457,
        13731.693765509461125, 1971.5909503065514427, 133.14166789178437745, 3.3871328727963666080);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> CentralBelow(Vector256<double> x) => PortableLanes.Polynomial(
        x, 5226.4952788528545610, 28729.085735721942674, 39307.895800092710610, 21213.794301586595867,
        5394.1960214247511077, 687.18700749205790830, 42.313330701600911252, 1.0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> NearAbove(Vector256<double> x) => PortableLanes.Polynomial(
        x, 7.74545014278341407640e-4, 0.0227238449892691845833, 0.241780725177450611770, 1.27045825245236838258,
        3.64784832476320460504, 5.76949722146069140550, 4.63033784615654529590, 1.42343711074968357734);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> NearBelow(Vector256<double> x) => PortableLanes.Polynomial(
        x, 1.05075007164441684324e-9, 5.47593808499534494600e-4, 0.0151986665636164571966, 0.148103976427480074590,
        0.689767334985100004550, 1.67638483018380384940, 2.05319162663775882187, 1.0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> FarAbove(Vector256<double> x) => PortableLanes.Polynomial(
        x, 2.01033439929228813265e-7, 2.71155556874348757815e-5, 0.00124266094738807843860, 0.0265321895265761230930,
        0.296560571828504891230, 1.78482653991729133580, 5.46378491116411436990, 6.65790464350110377720);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> FarBelow(Vector256<double> x) => PortableLanes.Polynomial(
        x, 2.04426310338993978564e-15, 1.42151175831644588870e-7, 1.84631831751005468180e-5, 7.86869131145613259100e-4,
        0.0148753612908506148525, 0.136929880922735805310, 0.599832206555887937690, 1.0);
}
