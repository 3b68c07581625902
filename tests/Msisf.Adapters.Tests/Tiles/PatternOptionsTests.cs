using Msisf.Adapters.Tiles;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.Adapters.Tests.Tiles;

public class PatternOptionsTests
{
    [Theory]
    [InlineData(0.0, 4, 0)]
    [InlineData(0.5, 4, 2)]
    [InlineData(0.1, 64, 7)]
    [InlineData(0.1, 4, 1)]
    [InlineData(1.0, 1, 1)]
    public void MarginSamples_AnyMargin_IsRoundedUp(double degrees, int pixelsPerDegree, int expected) =>
        Assert.Equal(expected, new PatternOptions(degrees, PatternFormat.Mesh2).MarginSamples(pixelsPerDegree));

    [Theory]
    [InlineData(-0.1)]
    [InlineData(1.01)]
    [InlineData(double.NaN)]
    public void Constructor_ImpossibleMargin_SaysTheRange(double degrees) =>
        Assert.Contains(
            "to 1 degrees are possible",
            Assert.Throws<BadInputException>(() => new PatternOptions(degrees, PatternFormat.Mesh2)).Message,
            StringComparison.Ordinal);
}
