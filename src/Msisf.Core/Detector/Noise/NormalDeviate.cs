using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
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
    /// <param name="deviates">Receives as many deviates; does not overlap with them.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be drawn with unoptimised vectors
    public static void OfProbabilities(ReadOnlySpan<double> probabilities, Span<double> deviates)
    {
        Span<int> tails = stackalloc int[NoiseSource.MaxRun + NoiseSource.Lanes];
        Span<double> last = stackalloc double[NoiseSource.Lanes];
        int count = 0;
        int start = 0;
        for (; start <= probabilities.Length - NoiseSource.Lanes; start += NoiseSource.Lanes)
        {
            uint isTail = Central(probabilities.Slice(start, NoiseSource.Lanes), deviates.Slice(start, NoiseSource.Lanes));
            count = LaneList.Append(tails, count, start, isTail);
        }

        if (start < probabilities.Length)
        {
            last.Fill(0.5);
            probabilities[start..].CopyTo(last);
            uint isTail = Central(last, last);
            last[..(probabilities.Length - start)].CopyTo(deviates[start..]);
            count = LaneList.Append(tails, count, start, isTail);
        }

        FillTails(probabilities, tails[..count], deviates);
    }

    /// <summary>Eight deviates, right in the distribution's middle.</summary>
    /// <returns>A bit for each lane that lies outside.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static uint Central(ReadOnlySpan<double> probabilities, Span<double> deviates)
    {
        Vector512<double> fromMiddle = Vector512.Create(probabilities) - Vector512.Create(0.5);
        Vector512<double> r = Vector512.Create(CentralConstant) - (fromMiddle * fromMiddle);
        (fromMiddle * CentralAbove(r) / CentralBelow(r)).CopyTo(deviates);
        return (uint)Vector512.GreaterThan(Vector512.Abs(fromMiddle), Vector512.Create(CentralRange)).ExtractMostSignificantBits();
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void FillTails(ReadOnlySpan<double> probabilities, ReadOnlySpan<int> tails, Span<double> deviates)
    {
        Span<double> values = stackalloc double[NoiseSource.Lanes];
        values.Fill(0.5);
        for (int start = 0; start < tails.Length; start += NoiseSource.Lanes)
        {
            ReadOnlySpan<int> places = tails.Slice(start, Math.Min(NoiseSource.Lanes, tails.Length - start));
            for (int lane = 0; lane < places.Length; lane++)
            {
                values[lane] = probabilities[places[lane]];
            }

            Tail(Vector512.Create<double>(values)).CopyTo(values);
            for (int lane = 0; lane < places.Length; lane++)
            {
                deviates[places[lane]] = values[lane];
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Tail(Vector512<double> probability)
    {
        Vector512<double> outside = Vector512.Min(probability, Vector512<double>.One - probability);
        Vector512<double> r = Vector512.Sqrt(-PortableLanes.Log(outside));
        Vector512<double> near = r - Vector512.Create(NearTailOffset);
        Vector512<double> far = r - Vector512.Create(TailRange);
        Vector512<double> deviate = Vector512.ConditionalSelect(
            Vector512.LessThanOrEqual(r, Vector512.Create(TailRange)),
            NearAbove(near) / NearBelow(near),
            FarAbove(far) / FarBelow(far));
        return Vector512.ConditionalSelect(Vector512.LessThan(probability, Vector512.Create(0.5)), -deviate, deviate);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> CentralAbove(Vector512<double> x) => PortableLanes.Polynomial(
        x, 2509.0809287301226727, 33430.575583588128105, 67265.770927008700853, 45921.953931549871457,
        13731.693765509461125, 1971.5909503065514427, 133.14166789178437745, 3.3871328727963666080);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> CentralBelow(Vector512<double> x) => PortableLanes.Polynomial(
        x, 5226.4952788528545610, 28729.085735721942674, 39307.895800092710610, 21213.794301586595867,
        5394.1960214247511077, 687.18700749205790830, 42.313330701600911252, 1.0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> NearAbove(Vector512<double> x) => PortableLanes.Polynomial(
        x, 7.74545014278341407640e-4, 0.0227238449892691845833, 0.241780725177450611770, 1.27045825245236838258,
        3.64784832476320460504, 5.76949722146069140550, 4.63033784615654529590, 1.42343711074968357734);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> NearBelow(Vector512<double> x) => PortableLanes.Polynomial(
        x, 1.05075007164441684324e-9, 5.47593808499534494600e-4, 0.0151986665636164571966, 0.148103976427480074590,
        0.689767334985100004550, 1.67638483018380384940, 2.05319162663775882187, 1.0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> FarAbove(Vector512<double> x) => PortableLanes.Polynomial(
        x, 2.01033439929228813265e-7, 2.71155556874348757815e-5, 0.00124266094738807843860, 0.0265321895265761230930,
        0.296560571828504891230, 1.78482653991729133580, 5.46378491116411436990, 6.65790464350110377720);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> FarBelow(Vector512<double> x) => PortableLanes.Polynomial(
        x, 2.04426310338993978564e-15, 1.42151175831644588870e-7, 1.84631831751005468180e-5, 7.86869131145613259100e-4,
        0.0148753612908506148525, 0.136929880922735805310, 0.599832206555887937690, 1.0);
}

/// <summary>Appends the places of some of eight lanes to a list.</summary>
internal static class LaneList
{
    private const int Lanes = NoiseSource.Lanes;

    /// <summary>For each set of lanes eight bytes, the numbers of its lanes first.</summary>
    private static readonly byte[] Orders = [.. Enumerable.Range(0, 1 << Lanes).SelectMany(Order)];

    /// <summary>Appends without branches, because nobody can predict them.</summary>
    /// <param name="places">The list; has room for eight more.</param>
    /// <param name="count">Number of places in it.</param>
    /// <param name="start">Place of the first lane.</param>
    /// <param name="lanes">A bit for each lane.</param>
    /// <returns>The new number of places.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Append(Span<int> places, int count, int start, uint lanes)
    {
        Vector128<ushort> order = Vector128.WidenLower(
            Vector128.CreateScalar(MemoryMarshal.Cast<byte, ulong>(Orders)[(int)lanes]).AsByte());
        Vector256<int> widened = Vector256.Create(Vector128.WidenLower(order), Vector128.WidenUpper(order)).AsInt32();
        (widened + Vector256.Create(start)).CopyTo(places.Slice(count, Lanes));
        return count + BitOperations.PopCount(lanes);
    }

    private static IEnumerable<byte> Order(int lanes) =>
        Enumerable.Range(0, Lanes).OrderBy(lane => ((lanes >> lane) & 1) == 0).Select(lane => (byte)lane);
}

/// <summary>The upper tail of the normal distribution.</summary>
internal static class NormalTail
{
    /// <summary>Probability that a normal number of mean 0 is above a limit.</summary>
    /// <param name="deviation">Standard deviation; 0 for a number that is always 0.</param>
    /// <returns>0 to 1, right to 7.5e-8.</returns>
    /// <remarks>M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions, 26.2.17.</remarks>
    public static double Beyond(double limit, double deviation)
    {
        if (deviation == 0.0)
        {
            return limit > 0.0 ? 0.0 : 1.0;
        }

        double x = Math.Abs(limit / deviation);
        double t = 1.0 / (1.0 + (0.2316419 * x));
        double polynomial = t * (0.319381530 + (t * (-0.356563782 + (t * (1.781477937 + (t * (-1.821255978 + (t * 1.330274429))))))));
        double tail = Math.Exp(-0.5 * x * x) / Math.Sqrt(2.0 * Math.PI) * polynomial;
        return limit > 0.0 ? tail : 1.0 - tail;
    }
}
