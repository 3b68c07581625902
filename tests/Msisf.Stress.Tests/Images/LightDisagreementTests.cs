using Msisf.TestSupport.Images;
using Xunit;

namespace Msisf.Stress.Tests.Images;

public sealed class LightDisagreementTests
{
    [Fact]
    public void Of_DoubtfulPixels_DoNotCount()
    {
        // limb, edge of a shadow, grazed by the Sun: no opinion; then lit, dark, lit but dark, dark but lit
        double[,] coverage = { { 0.5, 1, 1, 1, 1, 1, 1 } };
        double[,] lit = { { 0.5, 0.5, 1, 1, 0, 1, 0 } };
        double[,] truth = { { 90, 90, 20, 120, 0, 120, 0 } };
        double[,] image = { { 0, 0, 0, 100, 5, 0, 120 } };
        LightDisagreement disagreement = LightDisagreement.Of(coverage, lit, truth, image);
        Assert.Equal(new LightDisagreement(Pixels: 4, DarkInstead: 1, LitInstead: 1), disagreement);
        Assert.Equal(0.5, disagreement.Fraction);
    }

    [Fact]
    public void Of_NothingButSky_IsNone() =>
        Assert.Equal(0.0, LightDisagreement.Of(new double[2, 2], new double[2, 2], new double[2, 2], new double[2, 2]).Fraction);
}
