using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Xunit;

namespace Msisf.Synthesis.Tests;

public sealed class CraterRaysTests
{
    /// <summary>What is taken off everywhere is what rays add: summed over samples, in the mean of many new craters of a size.</summary>
    [Theory]
    [InlineData(4.0)]
    [InlineData(300.0)]
    [InlineData(3000.0)]
    public void AreaOf_AnySize_IsTheSumOverTheGround(double radius)
    {
        const int Craters = 60;
        int side = 2 * (int)Math.Ceiling(6.0 * CraterRays.ReachOf(radius));
        PolarStereographic map = new(IsSouth: false, radius / 6.0, -2000.0, 3000.0);
        (double line, double sample) = map.PixelOf(map.DirectionOf(0.0, 0.0));
        MapFrame frame = new(map, (int)line - (side / 2), side, (int)sample - (side / 2), side);
        float[] sums = new float[frame.X.Length];
        Random random = new(3);
        for (int crater = 0; crater < Craters; crater++)
        {
            Vector3D centre = map.DirectionOf(random.NextDouble(), random.NextDouble());
            SelenographicPoint place = SelenographicPoint.Below(centre);
            Crater fresh = new(centre.Z, double.RadiansToDegrees(place.Longitude), radius, Freshness: 1.0);
            new CraterRays(new PlacedCrater(fresh), 0.9).AddTo(frame, sums);
        }

        // Pixels of a polar map are true to scale at the pole and a little smaller here.
        double scale = (map.DirectionOf(0.0, 1.0) - map.DirectionOf(0.0, 0.0)).Length * MoonConstants.ReferenceRadius;
        double area = sums.Sum(value => (double)value) * scale * scale / Craters;
        Assert.Equal(CraterRays.AreaOf(radius), area, 0.06 * area);
        Assert.All(sums, value => Assert.True(value >= 0.0f));
    }

    /// <summary>Elliott et al. (2018), eq. 2: rays of a crater of 1 km radius are up to 6.59 km long; ejecta reach 2.35 radii.</summary>
    [Theory]
    [InlineData(1000.0, 6.59)]
    [InlineData(4000.0, 9.5817)] // 6.59 x 4^1.27 / 4
    [InlineData(10.0, 2.35)]
    public void ReachOf_Radius_IsThePublishedOne(double radius, double radii) => Assert.Equal(radii, CraterRays.ReachOf(radius), 1e-3);

    /// <summary>Of 2^(-5 u) with u uniform: the mean of what is above the limit, by a sum of a million places.</summary>
    [Theory]
    [InlineData(0.1)]
    [InlineData(0.004)]
    public void MeanStrength_OfAllCraters_IsTheirMean(double share)
    {
        double from = Math.Pow(2.0, -5.0 * share);
        double sum = Enumerable.Range(0, 1_000_000).Sum(
            i => Math.Max((Math.Pow(2.0, -5.0 * ((i + 0.5) / 1e6)) - from) / (1.0 - from), 0.0));
        Assert.Equal(sum / 1e6, CraterRays.MeanStrength(share), 1e-6);
    }

    /// <summary>
    /// 750 Ma at the rate of Neukum et al. (2001), 8.38e-4 a Ga for each km2 above 1 km, are 6.3e-4 craters; in equilibrium there are
    /// 0.0794 (Trask 1966), so 0.8 percent of these have rays. Of small ones a tenth.
    /// </summary>
    [Theory]
    [InlineData(1000.0, 0.0079)]
    [InlineData(200.0, 0.0397)]
    [InlineData(5.0, 0.1)]
    public void ShareOf_Highlands_IsThatOfYoungCraters(double diameter, double share) =>
        Assert.Equal(share, CraterRays.ShareOf(diameter, CraterLaw.Published.CountAbove(diameter)), 1e-4);
}
