using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Numerics;

public class LaneMathTests
{
    /// <summary>1, relative: a handful of roundings.</summary>
    private const double Rounding = 2e-15;

    [Fact]
    public void ExpOfNegative_AnyExponent_IsTheSystems()
    {
        for (double x = 0.0; x > -690.0; x -= 0.0713)
        {
            double expected = Math.Exp(x);
            Assert.Equal(expected, LaneMath.ExpOfNegative(Vector512.Create(x))[0], expected * Rounding);
        }
    }

    [Fact]
    public void ExpOfNegative_Infinity_IsNothingBesideOne() =>
        Assert.InRange(LaneMath.ExpOfNegative(Vector512.Create(double.NegativeInfinity))[0], 0.0, 1e-300);

    [Fact]
    public void LogOfOnePlusInverse_AnyNumber_IsTheSystems()
    {
        for (double a = 1.0; a > 1e-290; a *= 0.937)
        {
            double b = Math.Min(1.0, 1.7 * a);
            LaneMath.LogOfOnePlusInverse(Vector512.Create(a), Vector512.Create(b), out Vector512<double> logA, out Vector512<double> logB);
            Assert.Equal(Math.Log((1.0 + a) / a), logA[0], Math.Log((1.0 + a) / a) * Rounding);
            Assert.Equal(Math.Log((1.0 + b) / b), logB[0], Math.Log((1.0 + b) / b) * Rounding);
        }
    }

    [Fact]
    public void ArcsinOverSine_UpToHalf_IsTheSystems()
    {
        for (double sineSquared = 1e-12; sineSquared <= 0.5; sineSquared = (1.01 * sineSquared) + 1e-5)
        {
            double sine = Math.Sqrt(sineSquared);
            double expected = Math.Atan2(sine, Math.Sqrt(1.0 - sineSquared)) / sine;
            Assert.Equal(expected, LaneMath.ArcsinOverSine(Vector512.Create(sineSquared))[0], expected * Rounding);
        }
    }
}
