using Msisf.Core.Numerics;
using Msisf.Core.Preview;
using Msisf.Core.Terrain;
using Xunit;

namespace Msisf.Core.Tests.Preview;

public sealed class SkyDirectionTests
{
    /// <summary>Degrees: the references have 12 decimals; 0.1 degrees beside a pole azimuths are rounded 600 times as much.</summary>
    private const double AngleTolerance = 1e-10;

    /// <summary>2010-04-03T00:00:00, of tests/reference/sun_in_the_sky.py.</summary>
    private static readonly Vector3D Sun2010 = new(1.074955473280883E+11, -1.042430734878975E+11, 4.036164305561261E+09);

    /// <summary>Azimuths and elevations of CSPICE N0067 (azlcpo_c): tests/reference/sun_in_the_sky.py.</summary>
    [Theory]
    [InlineData(0.0, 45.0, 271.544191711991, 0.879055570581)]
    [InlineData(-43.3, 348.8, 317.606781452807, 36.313719389042)]
    [InlineData(26.1, 3.6, 249.830854161373, 38.008609644000)]
    [InlineData(89.9, 120.0, 344.120674953112, 1.447161472422)]
    [InlineData(-89.5, 222.0, 93.866445856531, -1.578448846917)]
    [InlineData(60.0, 180.0, 47.622502359127, -19.602155140506)]
    [InlineData(10.0, 300.0, 117.175545001724, 72.093239863863)]
    public void Of_TheSunOf2010_IsWhereCSpiceHasIt(double latitude, double longitude, double azimuth, double elevation)
    {
        SkyDirection sun = SkyDirection.Of(Point(latitude, longitude), Sun2010);

        Assert.Equal(elevation, double.RadiansToDegrees(sun.Elevation), AngleTolerance);
        Assert.Equal(azimuth, double.RadiansToDegrees(sun.Azimuth!.Value), AngleTolerance);
    }

    [Fact]
    public void Of_APole_HasNoNorthButAnElevation()
    {
        SkyDirection sun = SkyDirection.Of(new Vector3D(1e-10, 0.0, -MoonConstants.ReferenceRadius), Sun2010);

        Assert.Null(sun.Azimuth);
        Assert.InRange(double.RadiansToDegrees(sun.Elevation), -2.0, -1.0);
    }

    [Theory]
    [InlineData(3.0, 90.0)]
    [InlineData(0.5, -90.0)]
    public void Of_ZenithAndNadir_HaveNoAzimuth(double factor, double elevation)
    {
        Vector3D point = Point(20.0, 30.0);

        SkyDirection sky = SkyDirection.Of(point, factor * point);

        Assert.Null(sky.Azimuth);
        Assert.Equal(elevation, double.RadiansToDegrees(sky.Elevation), AngleTolerance);
    }

    private static Vector3D Point(double latitude, double longitude) => MoonConstants.ReferenceRadius
        * new SelenographicPoint(double.DegreesToRadians(latitude), double.DegreesToRadians(longitude)).ToDirectionBodyFixed();
}
