using Msisf.Core.Detector.Noise;
using Xunit;

namespace Msisf.Core.Tests.Detector.Noise;

public sealed class NormalDeviateTests
{
    private const double Relative = 4e-16 * 8; // AS 241 promises 1e-16; sums of eight terms are rounded

    /// <summary>mpmath 1.3: sqrt(2) erfinv(2 p - 1) of the doubles, 40 digits.</summary>
    [Theory]
    [InlineData(0.975, 1.9599639845400538)]
    [InlineData(0.6, 0.25334710313579974)]
    [InlineData(0.05, -1.6448536269514727)]
    [InlineData(1e-10, -6.3613409024040557)]
    [InlineData(1e-14, -7.6506280929352692)]
    public void OfProbabilities_KnownProbability_IsTheQuantile(double probability, double expected)
    {
        double[] deviates = new double[6];
        NormalDeviate.OfProbabilities([0.3, 0.5, 0.9, 0.01, probability, 0.2], deviates);
        Assert.InRange(deviates[4], expected - (Relative * Math.Abs(expected)), expected + (Relative * Math.Abs(expected)));
        Assert.Equal(0.0, deviates[1]);
    }

    [Fact]
    public void Fill_ManyPixels_AreStandardNormal()
    {
        const int Pixels = 200_000;
        const double FourSigmas = 4.0;
        double[] deviates = new double[Pixels];
        for (int start = 0; start < Pixels; start += NoiseSource.MaxRun)
        {
            NormalDeviate.Fill(
                NoiseSource.OfFrame(1, 2), NoiseKind.Read, (uint)start,
                deviates.AsSpan(start, Math.Min(NoiseSource.MaxRun, Pixels - start)));
        }

        double mean = deviates.Average();
        double variance = deviates.Average(deviate => deviate * deviate);
        double fourth = deviates.Average(deviate => Math.Pow(deviate, 4.0));
        Assert.InRange(mean, -FourSigmas / Math.Sqrt(Pixels), FourSigmas / Math.Sqrt(Pixels));
        Assert.InRange(variance - 1.0, -FourSigmas * Math.Sqrt(2.0 / Pixels), FourSigmas * Math.Sqrt(2.0 / Pixels));
        Assert.InRange(fourth - 3.0, -FourSigmas * Math.Sqrt(96.0 / Pixels), FourSigmas * Math.Sqrt(96.0 / Pixels));
    }
}
