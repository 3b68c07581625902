using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Xunit;

namespace Msisf.Core.Tests.Surface;

public class GridDirectionsTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    [InlineData(4)]
    public void Latitude_EveryLine_IsThatOfItsAngle(int pixelsPerDegree)
    {
        GridDirections directions = new(pixelsPerDegree);
        int parts = 2 * pixelsPerDegree;
        Assert.All(
            Enumerable.Range(0, 180 * pixelsPerDegree),
            line => Assert.Equal(SineCosine.OfDegrees((90 * parts) - (2 * line) - 1, parts), directions.Latitude(line)));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    [InlineData(4)]
    public void Longitude_EverySample_IsThatOfItsAngle(int pixelsPerDegree)
    {
        GridDirections directions = new(pixelsPerDegree);
        Assert.All(
            Enumerable.Range(0, 360 * pixelsPerDegree),
            sample => Assert.Equal(SineCosine.OfDegrees((2 * sample) + 1, 2 * pixelsPerDegree), directions.Longitude(sample)));
    }
}
