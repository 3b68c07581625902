using Msisf.TestSupport.Images;
using Xunit;

namespace Msisf.Stress.Tests.Images;

public sealed class LimbDisplacementTests
{
    private const double Middle = DiscImage.Side / 2;

    /// <summary>px: a straight edge is found exactly; this is what sampled coverage and bilinear profiles of a curved one leave.</summary>
    private const double Accuracy = 0.06;

    private static readonly double[,] Truth = DiscImage.Draw(Middle, radius: 30.0);

    [Fact]
    public void Of_TheTruthItself_IsNotDisplaced()
    {
        LimbDisplacement displacement = LimbDisplacement.Of(Truth, Truth, Truth);
        Assert.InRange(displacement.Points, 150, 250);
        Assert.Equal((0.0, 0.0), (displacement.Rms, displacement.Largest));
    }

    [Theory]
    [InlineData(0.5)]
    [InlineData(-0.7)]
    [InlineData(2.0)]
    public void Of_LargerOrSmallerDisc_IsTheDifferenceOfTheRadii(double difference)
    {
        LimbDisplacement displacement = LimbDisplacement.Of(Truth, Truth, DiscImage.Draw(Middle, 30.0 + difference));
        Assert.Equal(Math.Abs(difference), displacement.Rms, Accuracy);
        Assert.Equal(Math.Abs(difference), displacement.Largest, 3.0 * Accuracy);
    }

    [Fact]
    public void Of_ShiftedDisc_IsTheShiftAtItsSidesAndNothingAboveAndBelow()
    {
        LimbDisplacement displacement = LimbDisplacement.Of(Truth, Truth, DiscImage.Draw(Middle + 1.0, 30.0));
        Assert.Equal(1.0, displacement.Largest, 2.0 * Accuracy);
        Assert.Equal(Math.Sqrt(0.5), displacement.Rms, Accuracy); // the mean of cos^2 is a half
    }

    [Fact]
    public void Of_HalfOfTheLimbInTheNight_CountsTheOtherHalf()
    {
        double[,] halfLit = DiscImage.Draw(Middle, 30.0, x => x < Middle ? 0.0 : 1.0);
        LimbDisplacement whole = LimbDisplacement.Of(Truth, Truth, Truth);
        LimbDisplacement lit = LimbDisplacement.Of(Truth, halfLit, halfLit);
        Assert.InRange(lit.Points, (0.5 * whole.Points) - 6, (0.5 * whole.Points) + 6);
        Assert.Equal(0, LimbDisplacement.Of(Truth, new double[DiscImage.Side, DiscImage.Side], Truth).Points);
    }

    [Fact]
    public void Of_ImageWithoutTheDisc_IsTheReachInwards()
    {
        LimbDisplacement displacement = LimbDisplacement.Of(Truth, Truth, new double[DiscImage.Side, DiscImage.Side]);
        Assert.InRange(displacement.Largest, LimbDisplacement.Reach, LimbDisplacement.Reach + 1.5);
    }

    [Fact]
    public void Of_ImagesOfDifferentSizes_IsRefused() =>
        Assert.Throws<ArgumentException>(() => LimbDisplacement.Of(Truth, Truth, new double[10, 10]));
}
