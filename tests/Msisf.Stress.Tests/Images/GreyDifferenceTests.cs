using Msisf.TestSupport;
using Msisf.TestSupport.Images;
using Xunit;

namespace Msisf.Stress.Tests.Images;

public sealed class GreyDifferenceTests
{
    [Fact]
    public void Of_SomeDifferences_CountsThoseAboveOneLevel()
    {
        double[,] truth = { { 0, 10, 100, 200 }, { 0, 0, 0, 0 } };
        double[,] image = { { 0, 11, 97, 204 }, { 0, 0, 0, 0 } };
        GreyDifference difference = GreyDifference.Of(truth, image);
        Assert.Equal(0.25, difference.DifferingFraction); // 97 and 204 of 8
        Assert.Equal(Math.Sqrt((1.0 + 9.0 + 16.0) / 8.0), difference.Rms, Rounding.OfChains);
        Assert.Equal(4.0, difference.Largest);
    }

    [Fact]
    public void Of_TheImageTurned_IsRefused() =>
        Assert.Throws<ArgumentException>(() => GreyDifference.Of(new double[2, 3], new double[3, 2]));
}
