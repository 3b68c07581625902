using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.App.Tests.Settings;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.App.Tests.Preparation;

/// <summary>Numbers that are most likely meant in another unit get a warning; plausible ones get none.</summary>
public sealed class PlausibleMistakesTests
{
    private const string Elements = "--kepler-set {1.9E6,0.05,0.7,1.1,0.9,2.0} --epoch 55289";

    [Theory]
    [InlineData(
        "--kepler-set {1.9E6,0.05,40,1.1,90,2} --epoch 55289 --time 55289",
        "omega 40 rad (if it is degrees: 0.6981317 rad), i 90 rad")]
    [InlineData("--kepler-set {1.9E6,0.05,0.7,1.1,0.9,-200} --epoch 55289 --time 55289", "M0 -200 rad (if it is degrees: -3.490659 rad)")]
    [InlineData(
        $"{Elements} --time 55289 --attitude {{0,0,0,1}} --attitude-transition {{0,0,10}}",
        "10 rad/s is more than a full turn a second")]
    [InlineData($"{Elements} --time-interval [55289:60:55289.5]", "step of 60 days is longer than the interval of 0.5 days")]
    [InlineData($"{Elements} --time-interval [55289:60:55289.5]", "If the step is seconds, write 0.0006944444444.")]
    [InlineData("--position 1,2,3E4 --time-interval [55289:60:55289.5]", "step of 60 days is longer")]
    [InlineData(
        "--fixed-state {55289,2E6,0,0,0,0,0,1} --motion {0,1.6E6,0,0,0,0}",
        "the camera moves at 1,600 km/s: velocities are in m/s. If 1600000 is mm/s, or km/s that were multiplied twice, write 1600.")]
    [InlineData("--position 1,2,1837400 --time 55289", "If 1837400 m is from the centre, write 100000.")]
    [InlineData("--position 1,2,1837.4 --time 55289", "If 1837.4 is kilometres from the Moon's centre, write 100000.")]
    [InlineData("--position 1,2,100 --time 55289", "If 100 is kilometres, write 100000; if it counts from the terrain, write terrain+100.")]
    [InlineData(
        "--position 0.5236,-1.0472,1E5 --time 55289",
        "--position: latitude and longitude are in degrees. If 0.5236,-1.0472 is radians, write 30.00,-60.00.")]
    [InlineData("--position 0,5.75959,1E5 --time 55289", "If 0,5.75959 is radians, write 0.00,330.00.")]
    [InlineData("--position -0.78540,0,terrain+1E5 --time 55289", "is radians, write -45.00,0.00.")]
    [InlineData(
        "--position 1,2,1E5 --look-at 0.1745,0.5236 --time 55289",
        "--look-at: latitude and longitude are in degrees. If 0.1745,0.5236 is radians, write 10.00,30.00.")]
    [InlineData(
        "--state-vectors {1.9E6,0,0,0,1.6,0} --epoch 55289 --time 55289",
        "the velocity of --state-vectors is in m/s. One in km/s is to be multiplied by 1000.")]
    public void In_OtherUnit_WarnsAndSaysWhatItWouldMean(string words, string message) => Assert.Contains(
        message,
        Assert.Single(PlausibleMistakes.In(TrajectorySettingsReader.Read(Given.Options(words)), CelestialBody.Moon)),
        StringComparison.Ordinal);

    [Theory]
    [InlineData("--kepler-set {1.9E6,0.05,6.2832,-6.2832,3.1416,6.28} --epoch 55289 --time 55289")] // full turns with four digits
    [InlineData($"{Elements} --time 55289 --attitude {{0,0,0,1}} --attitude-transition {{0,0,1}}")]
    [InlineData($"{Elements} --time-interval [55289:0.5:55289.5]")]
    [InlineData($"{Elements} --time-interval [55289:60:55289]")] // one time, on purpose
    [InlineData($"{Elements} --time-interval [55289:60:55200]")] // leads away: an error of its own
    [InlineData("--position 1,2,3E4 --times {55289}")]
    [InlineData("--position 1,2,terrain+1837400 --time 55289")]
    [InlineData("--position 1,2,100000 --time 55289")] // as the warnings advise
    [InlineData("--position 1,2,terrain+100 --time 55289")]
    [InlineData("--position 30.00,-60.00,1E5 --time 55289")]
    [InlineData("--position 1,2,-1500 --time 55289")] // in a crater
    [InlineData("--position 1,2,1000 --time 55289")]
    [InlineData("--position 0,0,1E5 --time 55289")]
    [InlineData("--position 0.6741,-1.0472,1E5 --time 55289")] // 38.62 degrees: not both
    [InlineData("--position 0.52,1.05,1E5 --time 55289")] // two digits may be anything
    [InlineData("--position 1.6581,0.5236,1E5 --time 55289")] // 95 degrees are no latitude
    [InlineData("--position 1,2,2E6 --time 55289")]
    [InlineData("--state-vectors {1.9E6,0,0,0,160,0} --epoch 55289 --time 55289")] // a landing from a tenth of the circular velocity
    [InlineData("--fixed-state {55289,2E6,2E6,0,0,0,0,1}")]
    [InlineData("--fixed-state {55289,2E6,2E6,0,0,0,0,1} --motion {0,1.6E3,0,0,0,0}")]
    public void In_Plausible_NoWarning(string words) =>
        Assert.Empty(PlausibleMistakes.In(TrajectorySettingsReader.Read(Given.Options(words)), CelestialBody.Moon));

    // 100 km high; a cell of LDEM_4 is 7.6 km wide.
    [Theory]
    [InlineData(0.01, 17.46, 7580.0, "--fov 0.01 is 36 seconds of arc: the images are 17.5 m wide")]
    [InlineData(0.7854, 1370.8, 7580.0, "0.7854 rad would be --fov 45.")]
    [InlineData(0.7854, 1370.8, 30.0, "0.7854 rad would be --fov 45.")] // 45 degrees to four digits, whatever the model
    [InlineData(
        0.7, 1221.7, 7580.0,
        "the images are 1.2 km wide on the ground at the nearest, a cell of the elevation model is 7.6 km. 0.7 rad")]
    public void FieldOfView_LikelyRadians_Warns(double degrees, double width, double cell, string message) =>
        Assert.Contains(message, Assert.Single(PlausibleMistakes.FieldOfView(degrees, width, cell)), StringComparison.Ordinal);

    [Theory]
    [InlineData(0.7, 1221.7, 118.0)] // an image of many cells shows that it is meant
    [InlineData(1.25, 2200.0, 118.0)]
    [InlineData(2.86, 4990.0, 118.0)]
    [InlineData(40.0, 500.0, 7580.0)] // a lander's camera near the ground
    public void FieldOfView_Plausible_NoWarning(double degrees, double width, double cell) =>
        Assert.Empty(PlausibleMistakes.FieldOfView(degrees, width, cell));

    [Theory]
    [InlineData(1837.4, "kilometres")]
    [InlineData(1.7E6, "in metres from the Moon's centre")]
    [InlineData(3.0, "in metres from the Moon's centre.")]
    [InlineData(100_000.0, "centre; if 100000 m is a height, 1837400 m from the centre is meant.")]
    public void Inside_PositionInsideTheMoon_SaysWhatItLooksLike(double distance, string message) =>
        Assert.Contains(
            message,
            PlausibleMistakes.Inside(new Vector3D(0.0, distance, 0.0), CelestialBody.Moon, trajectory: null),
            StringComparison.Ordinal);

    [Theory]
    [InlineData("--position 10,20,-5000", "The height is in metres over the sphere of 1737400 m; terrain+METRES counts from the")]
    [InlineData("--position 10,20,30", "If 30 is kilometres, write 30000.")]
    [InlineData("--position 10,20,terrain-5", "Heights over the terrain are in metres, upwards.")]
    public void Inside_PlaceInTheGround_SpeaksOfHeights(string words, string message)
    {
        string advice = PlausibleMistakes.Inside(
            new Vector3D(0.0, 1.735e6, 0.0), CelestialBody.Moon, TrajectorySettingsReader.Read(Given.Options($"{words} --time 55289")));

        Assert.Contains(message, advice, StringComparison.Ordinal);
        Assert.DoesNotContain("centre", advice, StringComparison.Ordinal);
    }
}
