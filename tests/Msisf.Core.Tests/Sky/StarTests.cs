using Msisf.Core.Detector;
using Msisf.Core.Numerics;
using Msisf.Core.Sky;
using Xunit;

namespace Msisf.Core.Tests.Sky;

/// <summary>Where a star is seen and how bright it is, against ERFA and numpy (tests/reference/stars.py).</summary>
public sealed class StarTests
{
    /// <summary>rad: 0.02 mas. ERFA's pmpx lets the light cross the observer's orbit, 0.17 mas in a century of Barnard's star.</summary>
    private const double SameDirection = 1e-10;

    /// <summary>1: the integrations of both sides are good to 1e-8.</summary>
    private const double SameRate = 1e-6;

    [Theory]
    [InlineData(101.28854105, -16.71314306, -546.01, -1223.07, 379.21, 35.0, 0.3, 0.9, 0.4,
        -0.18737910374851424, 0.93918672083260202, -0.287780080773684)]
    [InlineData(269.45402305, 4.66828815, -797.84, 10326.93, 549.01, 18.5, -0.98, 0.12, 0.05,
        -0.0095655615694045376, -0.99656088101482199, 0.082309844264364412)]
    [InlineData(37.95456067, 89.26410897, 44.48, -11.85, 7.54, 10.25, 0.5, -0.8, -0.35,
        0.010126066470953647, 0.0079012723477677668, 0.99991751293449804)]
    public void DirectionFrom_AgreesWithErfa(
        double ra, double dec, double east, double north, double parallax, double years, double x, double y, double z,
        double expectedX, double expectedY, double expectedZ)
    {
        const double Epoch = -8.75;
        Star star = Star.FromCatalogue("S", (ra, dec), (east, north), parallax, Epoch, 0.0, null);

        Vector3D actual = star.DirectionFrom(Epoch + years, new Vector3D(x, y, z));

        Assert.Equal(1.0, actual.Length, 1e-15);
        Assert.InRange(Vector3D.AngleBetween(actual, new Vector3D(expectedX, expectedY, expectedZ)), 0.0, SameDirection);
    }

    [Theory]
    [InlineData(0.6, -0.64, 0.48, 9e-5, 4e-5, -2e-5, 0.60007871633613286, -0.63994796537025112, 0.47997097393369004)]
    [InlineData(0.0, 0.0, 1.0, 1e-4, 0.0, 0.0, 1e-4, 0.0, 0.99999999500000003)]
    [InlineData(0.8, 0.6, 0.0, 0.3, -0.2, 0.5, 0.84826929281841301, 0.23126174441987227, 0.47640026493404403)]
    public void Aberration_AgreesWithErfa(
        double x, double y, double z, double vx, double vy, double vz, double expectedX, double expectedY, double expectedZ)
    {
        Vector3D actual = StellarAberration.Of(new Vector3D(x, y, z), new Vector3D(vx, vy, vz));

        Assert.InRange((actual - new Vector3D(expectedX, expectedY, expectedZ)).Length, 0.0, 1e-14); // ERFA's numbers have 17 digits
    }

    [Fact]
    public void TemperatureOf_ColourOfSun_IsThatOfBallesteros() => Assert.Equal(5779.0, StarSpectrum.TemperatureOf(0.65), 1.0);

    [Fact]
    public void Irradiance_MagnitudeZeroAt545Nanometres_IsThatOfBessell()
    {
        Assert.Equal(3.631e-11, new StarSpectrum(0.0, 1.2).IrradianceAt(545.0), 1e-20);
        Assert.Equal(3.631e-13, new StarSpectrum(5.0, -0.1).IrradianceAt(545.0), 1e-22);
    }

    [Theory]
    [InlineData(-1.44, 0.009, 4.45785605e+10)]
    [InlineData(0.03, 0.0, 1.152531e+10)]
    [InlineData(0.45, 1.5, 8.01617149e+09)]
    [InlineData(4.0, 0.653, 285122297)]
    [InlineData(6.0, -0.2, 48672188)]
    public void ElectronRate_AgreesWithNumpy(double magnitude, double colour, double expected)
    {
        SpectralResponse response = new(400.0, 700.0, new SpectralCurve(0.8), new SpectralCurve(0.5));
        StarBrightness brightness = new(response.ElectronRate);

        double actual = brightness.Of(Star.FromCatalogue("S", (0.0, 0.0), (0.0, 0.0), 0.0, 0.0, magnitude, colour));

        Assert.Equal(1.0, actual / expected, SameRate);
    }

    [Fact]
    public void ElectronRate_NoColour_IsThatOfTheSun()
    {
        StarBrightness brightness = new(new SpectralResponse(400.0, 700.0, new SpectralCurve(0.8), new SpectralCurve(0.5)).ElectronRate);

        Assert.Equal(1.0, brightness.Of(Star.FromCatalogue("S", (0.0, 0.0), (0.0, 0.0), 0.0, 0.0, 4.0, null)) / 285122297.0, SameRate);
    }
}
