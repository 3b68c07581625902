using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Numerics;

public sealed class SampleWeightsTests
{
    private static readonly double[] Uneven = [-3.0, -1.0, 0.5, 2.0];

    /// <summary>A polynomial of the degree that the samples determine is met everywhere, outside of them too.</summary>
    [Theory]
    [InlineData(-2.2)]
    [InlineData(0.5)]
    [InlineData(1.9)]
    [InlineData(2.7)]
    public void Hermite_PolynomialOfDegreeSeven_IsExact(double time)
    {
        (double Value, double Rate)[] ofValues = new (double, double)[Uneven.Length];
        (double Value, double Rate)[] ofRates = new (double, double)[Uneven.Length];

        SampleWeights.Hermite(Uneven, time, ofValues, ofRates);

        double value = 0.0;
        double rate = 0.0;
        for (int i = 0; i < Uneven.Length; i++)
        {
            value += (ofValues[i].Value * Seventh(Uneven[i])) + (ofRates[i].Value * SeventhRate(Uneven[i]));
            rate += (ofValues[i].Rate * Seventh(Uneven[i])) + (ofRates[i].Rate * SeventhRate(Uneven[i]));
        }

        Assert.Equal(Seventh(time), value, 1e-10); // weights of alternating sign take digits away
        Assert.Equal(SeventhRate(time), rate, 1e-10); // the same
    }

    [Theory]
    [InlineData(-2.2)]
    [InlineData(0.5)]
    [InlineData(2.7)]
    public void Lagrange_Cubic_IsExact(double time)
    {
        double[] values = new double[Uneven.Length];
        double[] rates = new double[Uneven.Length];

        SampleWeights.Lagrange(Uneven, time, values, rates);

        Assert.Equal(Cubic(time), Uneven.Select((at, i) => values[i] * Cubic(at)).Sum(), Rounding.OfChains);
        Assert.Equal((6.0 * time * time) - 1.0, Uneven.Select((at, i) => rates[i] * Cubic(at)).Sum(), Rounding.OfChains);
    }

    private static double Cubic(double t) => (2.0 * t * t * t) - t + 5.0;

    private static double Seventh(double t) => Math.Pow(t, 7.0) - (3.0 * Math.Pow(t, 4.0)) + t - 2.0;

    private static double SeventhRate(double t) => (7.0 * Math.Pow(t, 6.0)) - (12.0 * Math.Pow(t, 3.0)) + 1.0;
}
