using Msisf.Core.Maps;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Maps;

public sealed class GroundProjectionTests
{
    private const double Radius = 1_737_400.0;

    // J. Snyder, "Map projections, a working manual", USGS PP 1395 (1987), equations of the sphere: 12-1, 21-5 to 21-8 (k0 = 1), 20-3 and
    // 20-4, computed with Python's math for R = 1737400 m.
    public static TheoryData<MapKind, double, double, double, double, double, double> Places => new()
    {
        { MapKind.Equirectangular, 0.0, 10.0, 30.0, 40.0, 909700.5127244843, 909700.5127244843 },
        { MapKind.LongitudeLatitude, 0.0, 10.0, 30.0, 40.0, 40.0, 30.0 },
        { MapKind.LongitudeLatitude, 0.0, -175.0, 30.0, 40.0, -320.0, 30.0 }, // within half a turn of the middle
        { MapKind.PolarStereographic, 90.0, 0.0, 80.0, 30.0, 152002.80400994033, -263276.579438151 },
        { MapKind.PolarStereographic, -90.0, 0.0, -80.0, 30.0, 152002.80400994033, 263276.579438151 },
        { MapKind.Orthographic, -20.0, 30.0, 10.0, 50.0, 585198.1719392623, 833408.2319294657 },
    };

    [Theory]
    [MemberData(nameof(Places))]
    public void ToMap_Place_IsWhereSnyderHasIt(
        MapKind kind, double centreLatitude, double centreLongitude, double latitude, double longitude, double x, double y)
    {
        GroundProjection map = Map(kind, centreLatitude, centreLongitude);
        Vector3D direction = DirectionOf(latitude, longitude);

        (double foundX, double foundY) = map.ToMap(7.0 * direction)!.Value;

        Assert.Equal(x, foundX, Rounding.OfConvertedPlaces);
        Assert.Equal(y, foundY, Rounding.OfConvertedPlaces);
        Assert.InRange((map.ToDirection(x, y)!.Value - direction).Length, 0.0, Rounding.OfTurns);
    }

    [Theory]
    [InlineData(MapKind.PolarStereographic, 90.0, 0.0, -1.0, 30.0)]
    [InlineData(MapKind.PolarStereographic, -90.0, 0.0, 1.0, 30.0)]
    [InlineData(MapKind.Orthographic, -20.0, 30.0, 21.0, -150.0)]
    public void ToMap_OtherHalfOfTheSphere_IsNotShown(
        MapKind kind, double centreLatitude, double centreLongitude, double latitude, double longitude) =>
        Assert.Null(Map(kind, centreLatitude, centreLongitude).ToMap(DirectionOf(latitude, longitude)));

    [Theory]
    [InlineData(MapKind.LongitudeLatitude, 0.0, 1e-4)] // 174 degrees
    [InlineData(MapKind.Equirectangular, 3.15, 0.0)] // beyond half a turn
    [InlineData(MapKind.Equirectangular, 0.0, 1.58)] // beyond the pole
    [InlineData(MapKind.PolarStereographic, 1.5, 1.5)] // beyond the equator
    [InlineData(MapKind.Orthographic, 0.8, 0.8)] // beside the disc
    public void ToDirection_BeyondTheEnd_IsNothing(MapKind kind, double xInRadii, double yInRadii) => Assert.Null(
        Map(kind, kind == MapKind.PolarStereographic ? 90.0 : 0.0, 0.0).ToDirection(xInRadii * Radius, yInRadii * Radius));

    private static GroundProjection Map(MapKind kind, double latitude, double longitude) =>
        new(kind, double.DegreesToRadians(latitude), double.DegreesToRadians(longitude), Radius);

    private static Vector3D DirectionOf(double latitude, double longitude) =>
        new SelenographicPoint(double.DegreesToRadians(latitude), double.DegreesToRadians(longitude)).ToDirectionBodyFixed();
}
