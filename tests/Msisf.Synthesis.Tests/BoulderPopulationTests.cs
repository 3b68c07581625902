using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Synthesis.Tests;

public sealed class BoulderPopulationTests
{
    private const double Side = 600.0; // m: of the square in which boulders are counted

    private static readonly MareMask Highlands = new(FunctionGrid.Hilly(2), default);

    /// <summary>Half of the larger ones lie around craters, and the number over an area stays that of the law.</summary>
    [Theory]
    [InlineData(0.25, 600.0)]
    [InlineData(0.5, 1800.0)]
    public void Near_LargeSquare_HasAsManyAsTheLaw(double smallest, double side)
    {
        Boulder[] all = [.. InSquare(smallest, side).Boulders];
        double expected = (BoulderPopulation.CountAbove(smallest) - BoulderPopulation.CountAbove(4.0)) * side * side;
        Assert.InRange(all.Length / expected, 0.88, 1.12); // a few large craters have many of them
        Assert.Equal(2.3387e-3, BoulderPopulation.CountAbove(1.0), 1e-7); // 5e5 1000^-2.11 for each 100 m2
        double metres = all.Count(boulder => boulder.Radius > smallest) / (double)all.Length;
        Assert.InRange(metres, 0.18, 0.25); // 2^-2.11 = 0.23, less those above 4 m
        Assert.All(all, boulder =>
        {
            Assert.InRange(2.0 * boulder.Radius, smallest, 4.0);
            Assert.InRange(boulder.Height, 0.6 * boulder.Radius, 1.8 * boulder.Radius);
            Vector3D narrow = boulder.Radius / MoonConstants.ReferenceRadius * boulder.Narrow;
            Assert.Equal(0.0, boulder.HeightAt(boulder.Centre + narrow));
            Assert.InRange(boulder.HeightAt(boulder.Centre), 0.6 * boulder.Height, boulder.Height);
        });
    }

    /// <summary>On the ejecta of fresh craters of 2 to 16 m there are several times as many as elsewhere.</summary>
    [Fact]
    public void Near_FreshCraters_HaveMoreThanElsewhere()
    {
        var square = InSquare(0.25, Side);
        Boulder[] all = [.. square.Boulders];
        PlacedCrater[] fresh = [.. square.Craters.Where(crater => crater.Freshness >= 0.5 && crater.Diameter is >= 2.0 and < 8.0)];
        double area = fresh.Sum(crater => Math.PI * 0.75 * crater.Diameter * crater.Diameter); // out to a diameter from the centre
        int around = fresh.Sum(crater => all.Count(boulder =>
            (boulder.Centre - crater.Direction).Length / crater.Radius is >= 1.0 and <= 2.0));
        Assert.True(fresh.Length > 300, $"{fresh.Length} craters");
        Assert.InRange(around / area / (all.Length / (Side * Side)), 1.7, 8.0);
    }

    /// <summary>A form is as high and as wide as it says, and there are rounded, blocky and angular ones.</summary>
    [Fact]
    public void HeightAt_ManyForms_AreBodiesOfTheirHeight()
    {
        SplitMix64 random = SplitMix64.For(1, 2, 3, 4);
        double[] atHalf = new double[60];
        for (int number = 0; number < atHalf.Length; number++)
        {
            BoulderForm form = new(ref random);
            double highest = 0.0;
            for (int i = 0; i < 41 * 41; i++)
            {
                (double along, double across) = (((i / 41) - 20) / 20.0, ((i % 41) - 20) / 20.0);
                double height = form.HeightAt(along, across);
                Assert.InRange(height, 0.0, 1.0);
                Assert.True(height == 0.0 || double.Hypot(along, across) < 1.0);
                highest = Math.Max(highest, height);
            }

            Assert.InRange(highest, 0.6, 1.0);
            atHalf[number] = form.HeightAt(0.5, 0.0);
        }

        Assert.InRange(atHalf.Max() - atHalf.Min(), 0.2, 1.0);
    }

    /// <summary>Sides rise by three to four heights over half a length, so that cells show them; no form ends with a step.</summary>
    [Fact]
    public void HeightAt_AnyForm_IsNoSteeperThanCellsCanShow()
    {
        const double Step = 0.05; // half lengths
        SplitMix64 random = SplitMix64.For(5, 6, 7, 8);
        double steepest = 0.0;
        for (int number = 0; number < 200; number++)
        {
            BoulderForm form = new(ref random);
            (double sin, double cos) = Math.SinCos(number);
            for (double distance = 0.5; distance < 1.02; distance += 0.002)
            {
                double next = distance + Step;
                double rise = form.HeightAt(distance * cos, distance * sin) - form.HeightAt(next * cos, next * sin);
                steepest = Math.Max(steepest, Math.Abs(rise) / Step);
            }
        }

        Assert.InRange(steepest, 2.9, 4.2);
    }

    private static (IEnumerable<Boulder> Boulders, IEnumerable<PlacedCrater> Craters) InSquare(double smallest, double side)
    {
        CraterPopulation craters = new(1, Highlands, smallest, 4096.0, CraterLaw.Published, new CellMemory<PlacedCrater>());
        double degrees = double.RadiansToDegrees(side / MoonConstants.ReferenceRadius);
        BoulderPopulation boulders = new(1, smallest, craters, new CellMemory<Boulder>());
        const double South = 10.0;
        const double West = 200.0;
        double width = degrees / Math.Cos(double.DegreesToRadians(South));
        return (
            boulders.Near(South, South + degrees, West, width).Where(boulder => IsInside(boulder.Centre)),
            craters.PlacedNear(South, South + degrees, West, width).Where(crater => IsInside(crater.Direction)));

        bool IsInside(Vector3D direction)
        {
            SelenographicPoint point = SelenographicPoint.Below(direction);
            double latitude = double.RadiansToDegrees(point.Latitude) - South;
            double longitude = double.RadiansToDegrees(point.Longitude) - West;
            return latitude >= 0.0 && latitude < degrees && longitude >= 0.0 && longitude < width;
        }
    }
}
