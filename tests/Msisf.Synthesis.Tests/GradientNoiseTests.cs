using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Synthesis.Tests;

public sealed class GradientNoiseTests
{
    [Fact]
    public void At_ManyPlaces_HasTheSlopesThatAmplitudesAreComputedFrom()
    {
        const double Step = 1e-3;
        const int Count = 40_000;
        SplitMix64 random = SplitMix64.For(seed: 7, purpose: 99, row: 0, column: 0);
        double fine = 0.0;
        double half = 0.0;
        double mean = 0.0;
        for (int i = 0; i < Count; i++)
        {
            double x = 1000.0 * random.NextUniform();
            double y = 1000.0 * random.NextUniform();
            double z = 1000.0 * random.NextUniform();
            double here = At(x, y, z);
            fine += Square((At(x + Step, y, z) - here) / Step);
            half += Square((At(x + 0.3, y + 0.4, z) - here) / 0.5);
            mean += here;
        }

        double rms = Math.Sqrt(fine / Count);
        Assert.InRange(mean / Count, -0.005, 0.005); // some standard deviations of a mean of so many
        Assert.InRange(rms, 0.97 * GradientNoise.RmsSlope, 1.03 * GradientNoise.RmsSlope);
        Assert.InRange(Math.Sqrt(half / Count) / rms, 0.82, 0.87);
    }

    [Fact]
    public void At_AcrossLatticePlane_IsContinuous() =>
        Assert.Equal(At(3.0 - 1e-9, 0.3, 0.7), At(3.0, 0.3, 0.7), 1e-6); // the step times the steepest slope, and floats

    [Fact]
    public void At_OtherSeed_IsOtherNoise() => Assert.NotEqual(At(0.4, 0.3, 0.7), At(0.4, 0.3, 0.7, seed: 2));

    private static double Square(double value) => value * value;

    private static double At(double x, double y, double z, int seed = 1) => GradientNoise.At(
        Vector256.Create(x), Vector256.Create(x), Vector256.Create(y), Vector256.Create(y), Vector256.Create(z), Vector256.Create(z),
        seed)[5];
}
