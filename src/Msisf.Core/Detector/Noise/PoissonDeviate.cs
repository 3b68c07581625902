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

    private const int Lanes = NoiseSource.Lanes;

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
    public static void Replace(Span<double> means, ReadOnlySpan<double> uniforms)
    {
        Span<double> padded = stackalloc double[NoiseSource.MaxRun + Lanes];
        Span<double> deviates = stackalloc double[NoiseSource.MaxRun + Lanes];
        Span<double> u = stackalloc double[NoiseSource.MaxRun + Lanes];
        Span<int> open = stackalloc int[NoiseSource.MaxRun + Lanes];
        means.CopyTo(padded);
        uniforms.CopyTo(u);
        NormalDeviate.OfProbabilities(uniforms, deviates[..means.Length]);
        int count = 0;
        for (int start = 0; start < means.Length; start += Lanes)
        {
            Vector256<double> mean = LaneBuffer.Load(padded, start);
            Vector256<double> isSmall = Vector256.LessThan(mean, Vector256.Create(MinExpandedMean));
            uint small = isSmall.ExtractMostSignificantBits();
            uint unsure = 0;
            Vector256<double> number = small == 0b1111 ? default : Expanded(mean, LaneBuffer.Load(deviates, start), out unsure);
            if (small != 0)
            {
                Vector256<double> counted = CountedUp(mean & isSmall, LaneBuffer.Load(u, start));
                number = Vector256.ConditionalSelect(isSmall, counted, number);
            }

            LaneBuffer.Store(number, means, start);
            count = LaneBuffer.Append(open, count, start, unsure & ~small);
        }

        foreach (int place in open[..count])
        {
            if (place < means.Length)
            {
                means[place] = Summed(padded[place], u[place], means[place]);
            }
        }
    }

    /// <summary>The distribution's inverse by its expansion for large means.</summary>
    /// <param name="mean">At least <see cref="MinExpandedMean"/>; what comes out for smaller means is of no use.</param>
    /// <param name="deviate">Normal deviates of the same probabilities.</param>
    /// <param name="unsure">A bit for each lane in which a whole number lies within the error of the expansion.</param>
    private static Vector256<double> Expanded(Vector256<double> mean, Vector256<double> deviate, out uint unsure)
    {
        Vector256<double> root = Vector256.Sqrt(mean);
        Vector256<double> inverseRoot = Vector256<double>.One / root;
        Vector256<double> square = deviate * deviate;
        Vector256<double> skew = Vector256.Create(1.0 / 3.0) + (square * Vector256.Create(1.0 / 6.0));
        Vector256<double> flattening = Vector256<double>.One - (deviate * inverseRoot * Vector256.Create(1.0 / 12.0));
        Vector256<double> inverse = mean + ((root * deviate) + (skew * flattening));
        Vector256<double> error = Vector256.Create(1.0 / 40.0)
            + (square * (Vector256.Create(1.0 / 80.0) + (square * Vector256.Create(1.0 / 160.0))));
        error *= inverseRoot * inverseRoot;

        Vector256<double> number = Vector256.Floor(inverse);
        Vector256<double> rest = inverse - number;
        Vector256<double> isFar = Vector256.GreaterThan(square, Vector256.Create(MaxDeviate * MaxDeviate))
            & Vector256.GreaterThan(square, mean * Vector256.Create(MaxSquareOverMean));
        Vector256<double> isNear = Vector256.LessThanOrEqual(rest, error)
            | Vector256.GreaterThanOrEqual(rest, Vector256<double>.One - error);
        Vector256<double> isSummed = Vector256.LessThanOrEqual(mean, Vector256.Create(MaxSummedMean));
        unsure = ((isFar | isNear) & isSummed).ExtractMostSignificantBits();
        return Vector256.Max(number, Vector256<double>.Zero);
    }

    /// <summary>The distribution's inverse for small means.</summary>
    private static Vector256<double> CountedUp(Vector256<double> mean, Vector256<double> u)
    {
        Vector256<double> probability = PortableLanes.Exp(-mean);
        Vector256<double> cumulated = probability;
        Vector256<double> count = Vector256<double>.Zero;
        Vector256<double> isAbove = Vector256.GreaterThan(u, cumulated);
        for (int next = 1; next < MaxCountedUp && isAbove.ExtractMostSignificantBits() != 0; next++)
        {
            count += isAbove & Vector256<double>.One;
            probability *= mean * Vector256.Create(Reciprocals[next]);
            cumulated += probability;
            isAbove = Vector256.GreaterThan(u, cumulated);
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
