using Msisf.TestSupport;
using Xunit;

namespace Msisf.Synthesis.Tests;

public sealed class CraterPopulationTests
{
    private const double PoissonSigmas = 4.0; // one false alarm in 16,000 bins
    private static readonly MareMask NoMaria = new(FunctionGrid.OfHeights(1, (_, _) => 0.0), CancellationToken.None);

    [Fact]
    public void Near_WholeHighlandsMoon_FollowsTraskInEveryBin()
    {
        const double MoonKm2 = 4.0 * Math.PI * 1737.4 * 1737.4;
        double[] diametersKm = [.. new CraterPopulation(seed: 5, NoMaria, smallest: 8000.0, largest: 150_000.0)
            .Near(-90.0, 90.0, 0.0, 360.0).Select(crater => 2e-3 * crater.Radius)];
        for (double min = 8.0; min < 100.0; min *= 1.5)
        {
            double expected = MoonKm2 * 0.079 * (Math.Pow(min, -1.83) - Math.Pow(1.5 * min, -1.83));
            int counted = diametersKm.Count(diameter => diameter >= min && diameter < 1.5 * min);
            Assert.InRange(counted, expected - (PoissonSigmas * Math.Sqrt(expected)), expected + (PoissonSigmas * Math.Sqrt(expected)));
        }
    }

    [Theory]
    [InlineData(60.0, 90.0)]
    [InlineData(-30.0, 30.0)]
    [InlineData(-90.0, -85.0)]
    public void Near_AnyLatitudes_HasTheDensityOfItsArea(double south, double north)
    {
        Crater[] all = [.. new CraterPopulation(seed: 6, NoMaria, smallest: 8000.0, largest: 60_000.0).Near(-90.0, 90.0, 0.0, 360.0)];
        double part = 0.5 * (Math.Sin(north * Math.PI / 180.0) - Math.Sin(south * Math.PI / 180.0));
        double expected = part * all.Length;
        int counted = all.Count(crater => crater.LatitudeDegrees >= south && crater.LatitudeDegrees < north);
        Assert.InRange(counted, expected - (PoissonSigmas * Math.Sqrt(expected)), expected + (PoissonSigmas * Math.Sqrt(expected)));
    }

    [Theory]
    [InlineData(10.0, 20.0, 350.0, 20.0)]
    [InlineData(80.0, 90.5, 100.0, 20.0)]
    [InlineData(-90.75, -84.0, -5.0, 10.0)]
    public void Near_Block_HasEveryCraterThatReachesItInTheSameOrder(double south, double north, double west, double width)
    {
        CraterPopulation population = new(seed: 7, NoMaria, smallest: 12_000.0, largest: 60_000.0);
        Crater[] all = [.. population.Near(-90.0, 90.0, 0.0, 360.0)];
        Crater[] near = [.. population.Near(south, north, west, width)];
        Assert.Equal(all.Where(near.ToHashSet().Contains), near);
        Assert.InRange(near.Length, 1, all.Length / 4);
        Crater[] reaching = [.. all.Where(crater => Reaches(crater, south, north, west, width))];
        Assert.NotEmpty(reaching);
        Assert.Subset(near.ToHashSet(), reaching.ToHashSet());
    }

    [Fact]
    public void Near_Mare_HasTheProductionOfItsAge()
    {
        MareMask maria = new(FunctionGrid.HighlandsAndMare(1), CancellationToken.None);
        Crater[] craters = [.. new CraterPopulation(seed: 8, maria, smallest: 1000.0, largest: 2000.0).Near(-10.0, 10.0, 350.0, 20.0)
            .Where(
                crater => Math.Abs(crater.LatitudeDegrees) < 10.0 && Math.Abs(Math.IEEERemainder(crater.LongitudeDegrees, 360.0)) < 10.0)];
        double km2 = 1737.4 * 1737.4 * (20.0 * Math.PI / 180.0) * 2.0 * Math.Sin(10.0 * Math.PI / 180.0);

        // 3e-3 D^-3 per km2 is the cumulative law as a part of Trask's at each diameter: integrate their product.
        double expected = Enumerable.Range(0, 1000).Sum(i => Density(1.0 + ((i + 0.5) / 1000.0)) / 1000.0) * km2;
        Assert.InRange(craters.Length, expected - (PoissonSigmas * Math.Sqrt(expected)), expected + (PoissonSigmas * Math.Sqrt(expected)));

        static double Density(double km) => 1.83 * 0.079 * Math.Pow(km, -2.83) * (3e-3 / 0.079 * Math.Pow(km, -1.17));
    }

    // By great-circle distance to a grid of the block's points; beyond a pole the latitude folds back.
    private static bool Reaches(Crater crater, double south, double north, double west, double width)
    {
        double cosReach = Math.Cos(0.99 * Crater.Reach * crater.Radius / 1_737_400.0);
        for (int i = 0; i <= 20; i++)
        {
            for (int j = 0; j <= 20; j++)
            {
                double latitude = (south + (i * (north - south) / 20.0)) * Math.PI / 180.0;
                double longitude = (west + (j * width / 20.0) - crater.LongitudeDegrees) * Math.PI / 180.0;
                double cos = (Math.Sin(latitude) * crater.SinLatitude) + (Math.Cos(latitude) * crater.CosLatitude * Math.Cos(longitude));
                if (cos > cosReach)
                {
                    return true;
                }
            }
        }

        return false;
    }
}
