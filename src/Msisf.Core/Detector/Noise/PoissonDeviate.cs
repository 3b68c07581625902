using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Detector.Noise;

/// <summary>
/// Poisson deviates by inversion of the distribution, at every mean: the smallest number n of events for which P(N &lt;= n) is not below a
/// uniform number. No approximation remains: where an expansion is not sure of n, the probabilities are summed.
/// </summary>
/// <remarks>
/// M. B. Giles, "Algorithm 955: approximation of the inverse Poisson cumulative distribution function", ACM Transactions on Mathematical
/// Software 42 (2016). Made of exact operations only, so every machine gets the same numbers.
/// </remarks>
internal static class PoissonDeviate
{
    /// <summary>Below this mean the probabilities are summed from 0 on.</summary>
    private const double MinExpandedMean = 10.0;

    /// <summary>
    /// Above this mean the expansion is taken as it is: its error is below 1e-7 events there, far less than the rounding of a sum of
    /// probabilities would be.
    /// </summary>
    private const double MaxSummedMean = 1e8;

    // The expansion's error bound holds for normal deviates up to 3, and up to a sixth of the mean's root: tests/reference/poisson.py.
    private const double MaxDeviate = 3.0;
    private const double MaxSquareOverMean = 1.0 / 36.0;

    /// <summary>Above the largest number of events at a mean of 10 that a uniform number of 53 bits can reach, which is 45.</summary>
    private const int MaxCountedUp = 64;

    /// <summary>
    /// So many events are counted before it is asked whether that was enough: to count on changes nothing. Divides the maximum less one.
    /// </summary>
    private const int CountsPerCheck = 3;

    private const int Lanes = NoiseSource.Lanes;
    private const uint AllLanes = (1u << Lanes) - 1;

    private static readonly double[] Reciprocals = [0.0, .. Enumerable.Range(1, MaxCountedUp).Select(count => 1.0 / count)];

    /// <summary>A number of events.</summary>
    /// <param name="mean">Mean number, finite, at least 0.</param>
    /// <param name="uniform">Between 0 and 1, without both ends.</param>
    public static double Of(double mean, double uniform)
    {
        Span<double> count = [mean];
        Replace(count, [uniform]);
        return count[0];
    }

    /// <summary>Replaces mean numbers of events by numbers of events.</summary>
    /// <param name="means">Finite, at least 0; at most <see cref="NoiseSource.MaxRun"/>. Become whole numbers.</param>
    /// <param name="uniforms">As many numbers between 0 and 1, without both ends.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be drawn with unoptimised vectors
    public static void Replace(Span<double> means, ReadOnlySpan<double> uniforms)
    {
        Span<double> numbers = stackalloc double[NoiseSource.MaxRun + Lanes];
        NormalDeviate.OfProbabilities(uniforms, numbers[..means.Length]);
        int start = 0;
        for (; start <= means.Length - Lanes; start += Lanes)
        {
            ReplaceDeviates(means.Slice(start, Lanes), uniforms.Slice(start, Lanes), numbers.Slice(start, Lanes));
        }

        if (start < means.Length)
        {
            Span<double> lastMeans = stackalloc double[Lanes];
            Span<double> lastUniforms = stackalloc double[Lanes];
            means[start..].CopyTo(lastMeans);
            uniforms[start..].CopyTo(lastUniforms);
            ReplaceDeviates(lastMeans, lastUniforms, numbers.Slice(start, Lanes));
        }

        numbers[..means.Length].CopyTo(means);
    }

    /// <summary>Replaces eight normal deviates by numbers of events.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void ReplaceDeviates(ReadOnlySpan<double> means, ReadOnlySpan<double> uniforms, Span<double> deviates)
    {
        Vector512<double> mean = Vector512.Create(means);
        Vector512<double> isSmall = Vector512.LessThan(mean, Vector512.Create(MinExpandedMean));
        uint small = (uint)isSmall.ExtractMostSignificantBits();
        uint unsure = 0;
        Vector512<double> number = small == AllLanes ? default : Expanded(mean, Vector512.Create<double>(deviates), out unsure);
        if (small != 0)
        {
            number = Vector512.ConditionalSelect(isSmall, CountedUp(mean & isSmall, Vector512.Create(uniforms)), number);
        }

        number.CopyTo(deviates);
        for (unsure &= ~small; unsure != 0; unsure &= unsure - 1)
        {
            int lane = BitOperations.TrailingZeroCount(unsure);
            deviates[lane] = Summed(means[lane], uniforms[lane], deviates[lane]);
        }
    }

    /// <summary>The distribution's inverse by its expansion for large means.</summary>
    /// <param name="mean">At least <see cref="MinExpandedMean"/>; what comes out for smaller means is of no use.</param>
    /// <param name="deviate">Normal deviates of the same probabilities.</param>
    /// <param name="unsure">A bit for each lane in which a whole number lies within the error of the expansion.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Expanded(Vector512<double> mean, Vector512<double> deviate, out uint unsure)
    {
        Vector512<double> root = Vector512.Sqrt(mean);
        Vector512<double> inverseRoot = Vector512<double>.One / root;
        Vector512<double> square = deviate * deviate;
        Vector512<double> skew = Vector512.Create(1.0 / 3.0) + (square * Vector512.Create(1.0 / 6.0));
        Vector512<double> flattening = Vector512<double>.One - (deviate * inverseRoot * Vector512.Create(1.0 / 12.0));
        Vector512<double> inverse = mean + ((root * deviate) + (skew * flattening));
        Vector512<double> error = Vector512.Create(1.0 / 40.0)
            + (square * (Vector512.Create(1.0 / 80.0) + (square * Vector512.Create(1.0 / 160.0))));
        error *= inverseRoot * inverseRoot;

        Vector512<double> number = Vector512.Floor(inverse);
        Vector512<double> rest = inverse - number;
        Vector512<double> isFar = Vector512.GreaterThan(square, Vector512.Create(MaxDeviate * MaxDeviate))
            & Vector512.GreaterThan(square, mean * Vector512.Create(MaxSquareOverMean));
        Vector512<double> isNear = Vector512.LessThanOrEqual(rest, error)
            | Vector512.GreaterThanOrEqual(rest, Vector512<double>.One - error);
        Vector512<double> isSummed = Vector512.LessThanOrEqual(mean, Vector512.Create(MaxSummedMean));
        unsure = (uint)((isFar | isNear) & isSummed).ExtractMostSignificantBits();
        return Vector512.MaxNative(number, Vector512<double>.Zero);
    }

    /// <summary>The distribution's inverse for small means.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> CountedUp(Vector512<double> mean, Vector512<double> u)
    {
        Vector512<double> probability = PortableLanes.Exp(-mean);
        Vector512<double> cumulated = probability;
        Vector512<double> count = Vector512<double>.Zero;
        Vector512<double> isAbove = Vector512.GreaterThan(u, cumulated);
        for (int next = 1; next < MaxCountedUp && isAbove.ExtractMostSignificantBits() != 0; next += CountsPerCheck)
        {
            for (int more = 0; more < CountsPerCheck; more++)
            {
                count = Vector512.ConditionalSelect(
                    Vector512.GreaterThan(u, cumulated), count + Vector512<double>.One, count);
                probability *= mean * Vector512.Create(Reciprocals[next + more]);
                cumulated += probability;
            }

            isAbove = Vector512.GreaterThan(u, cumulated);
        }

        return count;
    }

    /// <summary>The distribution's inverse from a number near it.</summary>
    private static double Summed(double mean, double u, double number)
    {
        // From the nearer end, so that nothing cancels: with the part below for u up to 1/2, with the part above for larger ones.
        double probability = PoissonProbability.Of(number, mean);
        if (u <= 0.5)
        {
            double atMost = PoissonProbability.OfAtMost(number, probability, mean);
            for (; atMost < u; atMost += probability)
            {
                number++;
                probability *= mean / number;
            }

            for (; number > 0.0 && atMost - probability >= u; number--)
            {
                atMost -= probability;
                probability *= number / mean;
            }

            return number;
        }

        double above = PoissonProbability.OfMoreThan(number, probability, mean);
        double outside = 1.0 - u; // exact
        for (; above > outside; above -= probability)
        {
            number++;
            probability *= mean / number;
        }

        for (; number > 0.0 && above + probability <= outside; number--)
        {
            above += probability;
            probability *= number / mean;
        }

        return number;
    }
}
