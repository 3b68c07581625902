using FsCheck;
using FsCheck.Fluent;
using Msisf.Core.Ephemeris;
using Xunit;

namespace Msisf.Core.Tests.Ephemeris;

public class ChebyshevTests
{
    [Fact]
    public void Evaluate_FourTerms_IsTheSumByHand()
    {
        // x = 1/4: T1 = 1/4, T2 = -7/8, T3 = -11/16, all exact in binary.
        Assert.Equal(1.0 + (2.0 / 4.0) - (3.0 * 7.0 / 8.0) - (4.0 * 11.0 / 16.0), Chebyshev.Evaluate([1.0, 2.0, 3.0, 4.0], 0.25));
    }

    [Fact]
    public void Evaluate_OneTerm_IsThatTerm() => Assert.Equal(7.5, Chebyshev.Evaluate([7.5], 0.9));

    [Theory]
    [InlineData(1.0, 10.0)]
    [InlineData(-1.0, -2.0)]
    public void Evaluate_EndOfRange_IsTheSumWithSigns(double x, double expected) =>
        Assert.Equal(expected, Chebyshev.Evaluate([1.0, 2.0, 3.0, 4.0], x));

    [Fact]
    public void Derivative_FourTerms_IsTheSumByHand()
    {
        // x = 1/4: T1' = 1, T2' = 4x = 1, T3' = 12x^2 - 3 = -9/4.
        Assert.Equal(2.0 + (3.0 * 1.0) - (4.0 * 9.0 / 4.0), Chebyshev.Derivative([1.0, 2.0, 3.0, 4.0], 0.25));
    }

    [Theory]
    [InlineData(1.0, 50.0)]
    [InlineData(-1.0, 26.0)]
    public void Derivative_EndOfRange_IsTheSumOfSquares(double x, double expected) =>
        Assert.Equal(expected, Chebyshev.Derivative([1.0, 2.0, 3.0, 4.0], x));

    [Fact]
    public void Derivative_OneTerm_IsNone() => Assert.Equal(0.0, Chebyshev.Derivative([7.5], 0.9));

    [Fact]
    public void Evaluate_AnySeries_IsTheSumOfCosines()
    {
        Arbitrary<(int, int)> seedsAndThousandths = (from seed in Gen.Choose(0, 1_000_000)
                                                     from thousandth in Gen.Choose(0, 3141)
                                                     select (seed, thousandth)).ToArbitrary();
        Prop.ForAll(seedsAndThousandths, pair =>
            {
                Random random = new(pair.Item1);
                double[] coefficients = [.. Enumerable.Range(0, 13).Select(_ => random.NextDouble() - 0.5)];
                double angle = pair.Item2 / 1000.0;
                double sum = coefficients.Select((coefficient, k) => coefficient * Math.Cos(k * angle)).Sum();

                // 13 terms of size 1/2, and cos(angle) rounds x near the ends, where T12 rises 144 times as fast.
                return Math.Abs(Chebyshev.Evaluate(coefficients, Math.Cos(angle)) - sum) < 1e-13;
            })
            .Check(Config.QuickThrowOnFailure.WithMaxTest(500).WithReplay(20120222UL, 1UL));
    }
}
