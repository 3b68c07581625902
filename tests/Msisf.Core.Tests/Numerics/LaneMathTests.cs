using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Numerics;

public class LaneMathTests
{
    /// <summary>1, relative: a handful of roundings.</summary>
    private const double Rounding = 2e-15;

    /// <summary>1, relative: the error of the polynomial's coefficients.</summary>
    private const double FitOfArcsin = 1e-14;

    [Fact]
    public void ExpMinusOne_AnyExponent_IsTheSystems()
    {
        for (double x = -0.5; x > -690.0; x -= 0.0713)
        {
            Assert.Equal(Math.Exp(x) - 1.0, LaneMath.ExpMinusOne(Vector512.Create(x))[0], Rounding);
        }
    }

    [Fact]
    public void ExpMinusOne_BesideZero_IsItsSeries()
    {
        for (double x = -1e-3; x < -1e-200; x *= 0.771)
        {
            double expected = x * (1.0 + (x / 2.0 * (1.0 + (x / 3.0 * (1.0 + (x / 4.0 * (1.0 + (x / 5.0))))))));
            Assert.Equal(expected, LaneMath.ExpMinusOne(Vector512.Create(x))[0], -expected * Rounding);
        }

        Assert.Equal(0.0, LaneMath.ExpMinusOne(Vector512<double>.Zero)[0]);
    }

    [Fact]
    public void ExpMinusOne_Infinity_IsMinusOne() =>
        Assert.Equal(-1.0, LaneMath.ExpMinusOne(Vector512.Create(double.NegativeInfinity))[0]);

    [Fact]
    public void InPlace_AnyLength_IsThatOfSingleVectors()
    {
        Vector512<double>[] numbers = [.. Enumerable.Range(1, 5).Select(i => Vector512.Create(-0.3 * i))];
        Vector512<double>[] exponentials = [.. numbers];
        Vector512<double>[] roots = [.. numbers.Select(x => -x)];
        LaneMath.ExpMinusOne(exponentials);
        LaneMath.InverseSqrt(roots.AsSpan(0, 4));

        Assert.Equal(numbers.Select(LaneMath.ExpMinusOne), exponentials);
        Assert.Equal(numbers.Take(4).Select(x => LaneMath.InverseSqrt(-x)), roots[..4]);
        Assert.Equal(-numbers[4], roots[4]);
    }

    [Fact]
    public void InverseSqrt_AnyNumber_IsTheSystems()
    {
        for (double x = 1e-290; x < 1e290; x *= 1.13)
        {
            double expected = 1.0 / Math.Sqrt(x);
            Assert.Equal(expected, LaneMath.InverseSqrt(Vector512.Create(x))[0], expected * Rounding);
        }
    }

    [Fact]
    public void LogOf_SplitOnePlusInverse_IsTheSystems()
    {
        for (double a = 1.0; a > 1e-290; a *= 0.937)
        {
            double b = Math.Min(1.0, 1.7 * a);
            LaneMath.SplitOnePlusInverse(
                Vector512.Create(a), Vector512.Create(b), out Vector512<double> exponentA, out Vector512<double> exponentB,
                out Vector512<double> sA, out Vector512<double> sB);
            Assert.Equal(Math.Log((1.0 + a) / a), LaneMath.LogOf(exponentA, sA)[0], Math.Log((1.0 + a) / a) * Rounding);
            Assert.Equal(Math.Log((1.0 + b) / b), LaneMath.LogOf(exponentB, sB)[0], Math.Log((1.0 + b) / b) * Rounding);
        }
    }

    [Fact]
    public void ArcsinOverSineCosine_UpToHalf_IsTheSystems()
    {
        for (double sineSquared = 1e-12; sineSquared <= 0.5; sineSquared = (1.01 * sineSquared) + 1e-5)
        {
            double sine = Math.Sqrt(sineSquared);
            double cosine = Math.Sqrt(1.0 - sineSquared);
            double expected = Math.Atan2(sine, cosine) / (sine * cosine);
            Assert.Equal(expected, LaneMath.ArcsinOverSineCosine(Vector512.Create(sineSquared))[0], expected * FitOfArcsin);
        }
    }
}
