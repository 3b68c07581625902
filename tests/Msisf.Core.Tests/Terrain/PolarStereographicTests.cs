using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Terrain;

public sealed class PolarStereographicTests
{
    /// <summary>LDEM_80S_20M: longitude 0 is up, 90 degrees east to the right; at the north pole longitude 0 is down.</summary>
    [Theory]
    [InlineData(true, 0.0, 15199.5 - 15200.3, 15199.5)]
    [InlineData(true, 90.0, 15199.5, 15199.5 + 15200.3)]
    [InlineData(false, 0.0, 15199.5 + 15200.3, 15199.5)]
    [InlineData(false, 90.0, 15199.5, 15199.5 + 15200.3)]
    public void PixelOf_80Degrees_LiesWhereTheCatalogueSays(bool isSouth, double longitude, double line, double sample)
    {
        PolarStereographic map = new(isSouth, 20.0, 15199.5, 15199.5);
        Vector3D direction = new SelenographicPoint(
            double.DegreesToRadians(isSouth ? -80.0 : 80.0), double.DegreesToRadians(longitude)).ToDirectionBodyFixed();
        (double foundLine, double foundSample) = map.PixelOf(1_740_000.0 * direction);
        Assert.Equal(line, foundLine, 0.05); // 2 R tan(5 degrees) = 304,006 m
        Assert.Equal(sample, foundSample, 0.05);
    }

    [Theory]
    [InlineData(true, 20.0, 15199.5, 15199.5)]
    [InlineData(false, 5.0, 15167.5, 15167.5)]
    [InlineData(true, 100.0, 14399.5, 14399.5)]
    [InlineData(true, 1.0, -9000.25, 20000.75)]
    public void PixelOf_DirectionOfAPixel_IsThePixel(bool isSouth, double scale, double lineOffset, double sampleOffset)
    {
        PolarStereographic map = new(isSouth, scale, lineOffset, sampleOffset);
        Random random = new(20120222);
        for (int i = 0; i < 1000; i++)
        {
            (double line, double sample) = (30000.0 * random.NextDouble(), 30000.0 * random.NextDouble());
            (double backLine, double backSample) = map.PixelOf(map.DirectionOf(line, sample));
            Assert.Equal(line, backLine, 1e-9 * Math.Max(1.0, 100.0 / scale)); // an angle of 1e-16 is 2e-10 m
            Assert.Equal(sample, backSample, Rounding.OfPlaces * Math.Max(1.0, 100.0 / scale));
        }
    }

    [Fact]
    public void PixelOf_OppositePole_IsNoPixel()
    {
        (double line, double sample) = new PolarStereographic(true, 20.0, 15199.5, 15199.5).PixelOf(Vector3D.UnitZ);
        Assert.False(Math.Abs(line) < 1e9 && Math.Abs(sample) < 1e9);
    }

    [Theory]
    [InlineData(28800, 100.0, true)] // LDEM_45S_100M
    [InlineData(34746, 100.0, true)]
    [InlineData(34752, 100.0, false)]
    public void Holds_SizesOfMaps_UpToOneRadiusFromThePole(int side, double scale, bool holds) =>
        Assert.Equal(holds, new PolarStereographic(true, scale, 0.5 * (side - 1), 0.5 * (side - 1)).Holds(side, side));
}
