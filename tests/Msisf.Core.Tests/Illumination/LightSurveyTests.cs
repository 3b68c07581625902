using Msisf.Core.Illumination;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Xunit;

namespace Msisf.Core.Tests.Illumination;

/// <summary>What maps sum up over time, on a nested surface.</summary>
public sealed class LightSurveyTests(HardPlaces hard) : IClassFixture<HardPlaces>
{
    /// <summary>The paths of the Sun and the Earth are shared by neighbours: the same as if each was looked at alone.</summary>
    [Fact]
    public void Of_Neighbours_IsTheLightOfEachAlone()
    {
        const int Count = 40;
        Vector3D[] suns = [.. Enumerable.Range(0, 2000).Select(hour => HardPlaces.SunAt(hour / 24.0))];
        Vector3D[] earths = [.. suns.Select(sun => 3.8e8 * new SelenographicPoint(
            0.11 * Math.Sin(31.0 * sun.X / HardPlaces.SunDistance),
            0.13 * Math.Sin(17.0 * sun.Y / HardPlaces.SunDistance)).ToDirectionBodyFixed())];
        Vector3D[] row = [.. Enumerable.Range(0, Count).Select(place => new SelenographicPoint(
            double.DegreesToRadians(-89.4 + (0.002 * place)), 1.0 + (0.004 * place)).ToDirectionBodyFixed())];
        HorizonSurvey survey = new(hard.Terrain, hard.Tracer, row, isMoon: true);
        PlaceHorizons horizons = survey.Find(row, 0.0, threads: 2, advanced: null, CancellationToken.None);
        LightSurvey lights = new(survey, new LightConditions(suns, earths) { FixedPlane = new Vector3D(0.6, 0.0, 0.8) });
        PlaceLight[] together = lights.Of(row, horizons, threads: 2, advanced: null, CancellationToken.None);
        for (int place = 0; place < Count; place++)
        {
            PlaceLight alone = lights.At(row, horizons, place).Light;
            Assert.InRange(Math.Abs(alone.LitSteps - together[place].LitSteps), 0, 2);
            Assert.InRange(Math.Abs(alone.EarthSteps - together[place].EarthSteps), 0, 2);
            Assert.InRange(Math.Abs(alone.WholeEarthSteps - together[place].WholeEarthSteps), 0, 2);
            Assert.Equal(alone.DiscPart, together[place].DiscPart, 0.001); // the steps above, in a mean
            Assert.Equal(alone.Tracking.Mean, together[place].Tracking.Mean, 1.0);
            Assert.Equal(alone.Horizontal.Mean, together[place].Horizontal.Mean, 0.05); // W/m2: the same of a mean
            Assert.Equal(alone.Fixed.Mean, together[place].Fixed.Mean, 1.0);
        }
    }

    /// <summary>High in the sky all of the Sun's light comes: 1361 W/m^2 at one au, and its sine on a horizontal plane.</summary>
    [Fact]
    public void Of_SunHighAndLow_HasTheFluxOfItsDistance()
    {
        const double Au = 149_597_870_700.0;
        Vector3D[] place = [new SelenographicPoint(double.DegreesToRadians(-88.5), 2.0).ToDirectionBodyFixed()];
        HorizonSurvey survey = new(hard.Terrain, hard.Tracer, place, isMoon: true);
        PlaceHorizons horizons = survey.Find(place, 2.0, threads: 1, advanced: null, CancellationToken.None);
        LocalFrame frame = LocalFrame.At(horizons.Radii[0] * place[0]);
        Vector3D[] suns = [2.0 * Au * frame.DirectionOf(1.0, 0.6), Au * frame.DirectionOf(1.0, -0.6)];
        PlaceLight light = new LightSurvey(survey, new LightConditions(suns, suns))
            .Of(place, horizons, threads: 1, advanced: null, CancellationToken.None)[0];
        Assert.Equal(1361.0 / 4.0, light.Tracking.Greatest, 0.01);
        Assert.Equal(1361.0 / 8.0, light.Tracking.Mean, 0.01);
        Assert.Equal(1361.0 / 4.0 * Math.Sin(0.6), light.Horizontal.Greatest, 0.02);
        Assert.Equal((1, 1, 0.5), (light.LitSteps, light.Dark.Count, light.DiscPart));
    }
}
