using MathNet.Numerics.Distributions;
using Msisf.Core.Detector.Noise;
using Xunit;

namespace Msisf.Core.Tests.Detector.Noise;

public sealed class PoissonDeviateTests
{
    /// <summary>tests/reference/poisson.py, mpmath 1.3.</summary>
    [Theory]
    [InlineData(0.3, 0.5, 0.0)]
    [InlineData(0.3, 0.999, 3.0)]
    [InlineData(9.99, 0.2, 7.0)]
    [InlineData(10.0, 0.0001, 1.0)]
    [InlineData(10.0, 0.9999999, 30.0)]
    [InlineData(37.5, 0.5, 37.0)]
    [InlineData(1000.0, 1e-9, 816.0)]
    [InlineData(1000.0, 0.3, 983.0)]
    [InlineData(123456.7, 0.75, 123694.0)]
    [InlineData(4e6, 0.9999, 4007440.0)]
    public void Of_KnownMeanAndNumber_IsTheInverse(double mean, double uniform, double expected) =>
        Assert.Equal(expected, PoissonDeviate.Of(mean, uniform));

    /// <summary>Just inside each step of the distribution, where an approximation would be off by one.</summary>
    [Theory]
    [InlineData(0.7)]
    [InlineData(9.9)]
    [InlineData(10.0)]
    [InlineData(14.2)]
    [InlineData(60.0)]
    [InlineData(900.0)]
    public void Of_NumbersAtTheStepsOfTheDistribution_AreExact(double mean)
    {
        const double Part = 1e-9; // of a step
        Poisson distribution = new(mean);
        int first = (int)Math.Max(0.0, mean - (5.0 * Math.Sqrt(mean)));
        for (int n = first; n < mean + (5.0 * Math.Sqrt(mean)); n++)
        {
            double below = n == 0 ? 0.0 : distribution.CumulativeDistribution(n - 1);
            double step = distribution.Probability(n);
            Assert.Equal(n, PoissonDeviate.Of(mean, below + (Part * Math.Max(step, 1e-4))));
            Assert.Equal(n, PoissonDeviate.Of(mean, below + step - (Part * Math.Max(step, 1e-4))));
        }
    }

    [Theory]
    [InlineData(0.05)]
    [InlineData(2.5)]
    [InlineData(9.5)]
    [InlineData(11.0)]
    [InlineData(48.0)]
    public void Replace_ManyPixels_FollowTheDistribution(double mean)
    {
        const int Pixels = 400_000;
        const double Significance = 1e-4; // the seed is fixed: a failure is a fault, not chance
        int[] found = Histogram(mean, Pixels);
        (double chiSquare, int classes) = (0.0, 0);
        (double expectedRest, int foundRest) = (Pixels, Pixels);
        for (int n = 0; n < found.Length; n++)
        {
            double expected = Pixels * Poisson.PMF(mean, n);
            if (expected >= 10.0)
            {
                chiSquare += (found[n] - expected) * (found[n] - expected) / expected;
                (expectedRest, foundRest, classes) = (expectedRest - expected, foundRest - found[n], classes + 1);
            }
        }

        chiSquare += (foundRest - expectedRest) * (foundRest - expectedRest) / Math.Max(expectedRest, 1.0);
        Assert.InRange(ChiSquared.CDF(classes, chiSquare), Significance, 1.0 - Significance);
    }

    [Fact]
    public void Of_NoLight_NoElectrons() => Assert.Equal(0.0, PoissonDeviate.Of(0.0, 1.0 - 1e-16));

    private static int[] Histogram(double mean, int pixels)
    {
        int[] found = new int[200];
        double[] counts = new double[NoiseSource.MaxRun];
        double[] uniforms = new double[NoiseSource.MaxRun];
        for (int start = 0; start < pixels; start += counts.Length)
        {
            int count = Math.Min(counts.Length, pixels - start);
            Array.Fill(counts, mean);
            NoiseSource.OfFrame(5, 6).Fill(NoiseKind.Shot, (uint)start, uniforms);
            PoissonDeviate.Replace(counts.AsSpan(0, count), uniforms.AsSpan(0, count));
            foreach (double number in counts.AsSpan(0, count))
            {
                found[(int)number]++;
            }
        }

        return found;
    }
}
