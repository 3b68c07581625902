using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Xunit;

namespace Msisf.Core.Tests.Terrain;

public class SurfacePlaceTests
{
    // By hand: the reference sphere has 1,737,400 m.
    [Theory]
    [InlineData(0.0, 0.0, 600.0, false, 1738000.0, 0.0, 0.0)]
    [InlineData(0.0, 90.0, 600.0, false, 0.0, 1738000.0, 0.0)]
    [InlineData(0.0, -90.0, 600.0, false, 0.0, -1738000.0, 0.0)]
    [InlineData(-90.0, 12.0, -400.0, false, 0.0, 0.0, -1737000.0)]
    [InlineData(30.0, 180.0, 600.0, false, -1505152.1517773543, 0.0, 869000.0)]
    [InlineData(90.0, 0.0, 600.0, true, 0.0, 0.0, 1700600.0)] // the terrain below lies at 1,700,000 m
    public void ToPositionMoonMe_KnownPlaces_ByHand(
        double latitude, double longitude, double height, bool isOverTerrain, double x, double y, double z)
    {
        Vector3D found = new SurfacePlace(latitude, longitude, height, isOverTerrain).ToPositionBodyFixed(_ => 1.7e6);
        Assert.InRange((found - new Vector3D(x, y, z)).Length, 0.0, 1e-7);
    }

    [Theory]
    [InlineData(90.1, 0.0, 0.0, "The latitude (degrees) is 90.1")]
    [InlineData(double.NaN, 0.0, 0.0, "The latitude (degrees) is NaN")]
    [InlineData(0.0, 361.0, 0.0, "The longitude (degrees east) is 361")]
    [InlineData(0.0, 0.0, double.PositiveInfinity, "The height (m) is")]
    public void Constructor_OutOfRange_Refused(double latitude, double longitude, double height, string message) => Assert.StartsWith(
        message,
        Assert.Throws<BadInputException>(() => new SurfacePlace(latitude, longitude, height, isOverTerrain: false)).Message,
        StringComparison.Ordinal);
}
