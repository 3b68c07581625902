using Msisf.Adapters.Input;
using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;
using Xunit;

namespace Msisf.Adapters.Tests.Input;

public class PointingTextTests
{
    [Theory]
    [InlineData("-58.6,-14.5,180000", 180000.0, false)]
    [InlineData(" -58.6 , -14.5 , -100 ", -100.0, false)]
    [InlineData("-58.6,-14.5,terrain", 0.0, true)]
    [InlineData("-58.6,-14.5,Terrain+1.5E3", 1500.0, true)]
    [InlineData("-58.6,-14.5,terrain-2", -2.0, true)]
    public void ParsePosition_AnyHeight_IsThePlace(string text, double height, bool isOverTerrain) =>
        Assert.Equal(new SurfacePlace(-58.6, -14.5, height, isOverTerrain), PointingText.ParsePosition(text, CelestialBody.Moon));

    [Theory]
    [InlineData("-58.6,-14.5", "'-58.6,-14.5' has 2 parts; LAT,LON,HEIGHT or NAME,HEIGHT is needed")]
    [InlineData("-58.6 -14.5 3E4", "'-58.6 -14.5 3E4' has 1 part; LAT,LON,HEIGHT or NAME,HEIGHT is needed")]
    [InlineData("1,2,3,4", "'1,2,3,4' has 4 parts")]
    [InlineData("north,2,3", "the latitude (degrees): 'north' is not a number")]
    [InlineData("1,,3", "the longitude (degrees east): a number is missing")]
    [InlineData("1,2,terrain100", "'terrain100' is not a height; write metres over the sphere of 1737400 m, or 'terrain+METRES'")]
    [InlineData("1,2,ground", "'ground' is not a height")]
    [InlineData("1,2,", "'' is not a height")]
    [InlineData("170,20,3", "The latitude (degrees) is 170; a number from -90 to 90 is needed. Are latitude and longitude swapped?")]
    [InlineData("400,20,3", "The latitude (degrees) is 400; a number from -90 to 90 is needed.")]
    public void ParsePosition_Wrong_SaysWhat(string text, string message) => Assert.StartsWith(
        message,
        Assert.Throws<BadInputException>(() => PointingText.ParsePosition(text, CelestialBody.Moon)).Message,
        StringComparison.Ordinal);

    [Fact]
    public void ParseTarget_PlaceWithoutHeight_LiesOnTheTerrain()
    {
        Assert.Equal(new SurfacePlace(1.0, 2.0, 0.0, isOverTerrain: true), PointingText.ParseTarget("1,2", CelestialBody.Moon).Target);
        Assert.Equal(new SurfacePlace(1.0, 2.0, 0.0, isOverTerrain: false), PointingText.ParseTarget("1,2,0", CelestialBody.Moon).Target);
    }

    [Fact]
    public void ParseTarget_Words_WhateverTheirCase()
    {
        Assert.Equal(new CameraPointing(), PointingText.ParseTarget("NADIR", CelestialBody.Moon));
        Assert.Equal(new CameraPointing { Kind = BoresightKind.Sun }, PointingText.ParseTarget("Sun", CelestialBody.Moon));
        Assert.Equal(
            new CameraPointing { Kind = BoresightKind.Horizon, Azimuth = -Math.PI / 2.0 },
            PointingText.ParseTarget("Horizon:-90", CelestialBody.Moon));
    }

    [Theory]
    [InlineData("moon", "'moon' is nothing to look at; LAT,LON[,HEIGHT], NAME[,HEIGHT], nadir, sun or horizon:AZIMUTH is needed.")]
    [InlineData("horizon", "'horizon' is nothing to look at")]
    [InlineData("horizon:", "the azimuth (degrees): a number is missing")]
    [InlineData("1,2,3,4", "'1,2,3,4' has 4 parts")]
    public void ParseTarget_Wrong_SaysWhat(string text, string message) => Assert.StartsWith(
        message,
        Assert.Throws<BadInputException>(() => PointingText.ParseTarget(text, CelestialBody.Moon)).Message,
        StringComparison.Ordinal);

    [Fact]
    public void ParseOffNadir_AngleAndAzimuth_InRadians()
    {
        Assert.Equal(
            new CameraPointing { Kind = BoresightKind.OffNadir, OffNadir = Math.PI / 2.0, Azimuth = Math.PI },
            PointingText.ParseOffNadir("90,180"));
        Assert.Equal(0.0, PointingText.ParseOffNadir("30").Azimuth);
    }

    [Theory]
    [InlineData("181", "The angle from the nadir (degrees) is 181; a number from 0 to 180 is needed.")]
    [InlineData("-1", "The angle from the nadir (degrees) is -1")]
    [InlineData("30,x", "the azimuth (degrees): 'x' is not a number")]
    [InlineData("30,1,2", "'30,1,2' has 3 parts; ANGLE[,AZIMUTH] is needed, in degrees.")]
    public void ParseOffNadir_Wrong_SaysWhat(string text, string message) => Assert.StartsWith(
        message, Assert.Throws<BadInputException>(() => PointingText.ParseOffNadir(text)).Message, StringComparison.Ordinal);
}
