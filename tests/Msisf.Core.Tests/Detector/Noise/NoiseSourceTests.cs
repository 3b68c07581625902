using Msisf.Core.Detector.Noise;
using Xunit;

namespace Msisf.Core.Tests.Detector.Noise;

public sealed class NoiseSourceTests
{
    [Fact]
    public void Fill_RowCutAnywhere_GivesTheSameNumbers()
    {
        NoiseSource noise = NoiseSource.OfFrame(7, 99);
        double[] whole = new double[100];
        noise.Fill(NoiseKind.Shot, 1000, whole);
        for (int cut = 1; cut < whole.Length; cut++)
        {
            double[] parts = new double[whole.Length];
            noise.Fill(NoiseKind.Shot, 1000, parts.AsSpan(0, cut));
            noise.Fill(NoiseKind.Shot, (uint)(1000 + cut), parts.AsSpan(cut));
            Assert.Equal(whole, parts);
        }
    }

    [Fact]
    public void Fill_OtherSeedFrameOrKind_GivesOtherNumbers()
    {
        double[] numbers = new double[64];
        NoiseSource.OfFrame(7, 99).Fill(NoiseKind.Shot, 0, numbers);
        foreach ((NoiseSource noise, NoiseKind kind) in ((NoiseSource, NoiseKind)[])
            [(NoiseSource.OfFrame(8, 99), NoiseKind.Shot), (NoiseSource.OfFrame(7, 100), NoiseKind.Shot),
             (NoiseSource.OfFrame(7, 99 + (1UL << 32)), NoiseKind.Shot), (NoiseSource.OfFrame(7, 99), NoiseKind.Read)])
        {
            double[] others = new double[64];
            noise.Fill(kind, 0, others);
            Assert.Empty(numbers.Intersect(others));
        }
    }

    /// <summary>(n + 1/2) 2^-52 for the first 52 bits of the words that Random123 publishes for counter and key 0.</summary>
    [Fact]
    public void Uniforms_KindOfNumberZero_AreThePublishedBits()
    {
        (double first, double second) = NoiseSource.OfDetector(0).Uniforms(0, 0);
        Assert.Equal((0x6627e8d5e169cUL + 0.5) / (1UL << 52), first);
        Assert.Equal((0xbc57ac4c9b00dUL + 0.5) / (1UL << 52), second);
    }
}
