using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Surface.Sources;

/// <summary>Several maps without a model of the whole Moon around them, beside the same maps in one.</summary>
public sealed class MapsAloneTests
{
    /// <summary>Places along a side of the ground that is compared.</summary>
    private const int Places = 60;

    /// <summary>Where maps touch, the ground goes on as it does inside a model of the whole Moon, to the bit.</summary>
    /// <param name="maps">px/deg, northern latitude, western longitude, height and width in degrees; semicolons between maps.</param>
    [Theory]
    [InlineData("6 20 30 5 8; 6 20 38 5 8")] // beside each other
    [InlineData("6 20 30 5 8; 6 15 30 5 8")] // above each other
    [InlineData("6 20 30 5 8; 6 20 38 5 8; 6 15 30 5 8; 6 15 38 5 8")] // four at a corner
    [InlineData("6 20 355 5 5; 6 20 0 5 5")] // at the prime meridian
    [InlineData("6 -70 100 5 20; 6 -75 100 5 20; 6 -70 120 5 20")] // three in the south
    [InlineData("6 20 30 5 8; 24 19 38 3 3")] // a fine one beside a coarse one
    [InlineData("6 20 30 5 8; 24 19 34 3 3")] // a fine one on a coarse one
    [InlineData("6 20 30 5 8; 24 19 36 3 3")] // a fine one over the side of a coarse one
    [InlineData("6 20 30 5 8; 6 20 48 5 8")] // apart
    [InlineData("24 20 30 2 2; 24 20 32.5 2 2")] // apart by less than a degree
    public void Ground_OfMaps_IsThatInAModelOfTheWholeMoon(string maps)
    {
        ITerrainGrid[] models = MapsOf(maps);
        NestedTerrain alone = new(models);
        NestedTerrain around = new([.. models, FunctionGrid.Rugged(1)]);
        Assert.False(alone.IsWholeBody);
        Assert.False(alone.Surface.IsClosed);
        Assert.DoesNotContain(
            Enumerable.Range(0, 3 * alone.Surface.Seams.Count),
            corner => alone.Surface.Seams.VertexOf(corner / 3, corner % 3).Part is var part && (part < 0 || part >= models.Length));

        (double north, double south) = (Degrees(models.Max(NorthOf)), Degrees(models.Min(SouthOf)));
        (double west, double east) = LongitudesOf(maps);
        int compared = 0;
        for (int i = 0; i <= Places * Places; i++)
        {
            double latitude = north - ((i / Places) * (north - south) / Places);
            double longitude = west + ((i % Places) * (east - west) / Places) + 1e-4;
            Vector3D direction = new SelenographicPoint(double.DegreesToRadians(latitude), double.DegreesToRadians(longitude))
                .ToDirectionBodyFixed();
            double radius = TerrainHeight.RadiusBelow(alone, direction);
            if (IsWithin(maps, latitude, longitude))
            {
                Assert.Equal(TerrainHeight.RadiusBelow(around, direction), radius, 1e-6);
                compared++;
            }
            else if (IsOutside(maps, latitude, longitude))
            {
                Assert.Equal(MoonConstants.ReferenceRadius, radius);
            }
        }

        Assert.InRange(compared, 300, int.MaxValue);
    }

    /// <summary>
    /// A strip of squares, each of two facets, lies between two maps, up to its outer ends, and one square where four meet. Of the
    /// four, the northern ones give up a line and the western ones a sample, so two strips are a square shorter. None is between maps
    /// that lie apart.
    /// </summary>
    [Theory]
    [InlineData("6 20 30 5 8; 6 20 38 5 8", 2 * 29)]
    [InlineData("6 20 30 5 8; 6 15 30 5 8", 2 * 47)]
    [InlineData("6 20 30 5 8; 6 20 38 5 8; 6 15 30 5 8; 6 15 38 5 8", 2 * (28 + 29 + 46 + 47 + 1))]
    [InlineData("6 20 30 5 8; 6 20 48 5 8", 0)]
    [InlineData("24 20 30 2 2; 24 20 32.5 2 2", 0)]
    public void Seams_OfTouchingMaps_AreOneCellWide(string maps, int facets) =>
        Assert.Equal(facets, new NestedTerrain(MapsOf(maps)).Surface.Seams.Count);

    /// <summary>A hole is filled by a map below it, and stays one where there is none.</summary>
    [Theory]
    [InlineData(34.0, true)]
    [InlineData(38.0, false)]
    public void Hole_InAFineMap_IsFilledByACoarserOneOnly(double west, bool isFilled)
    {
        ITerrainGrid coarse = MapsOf("6 20 30 5 8")[0];
        ITerrainGrid fine = MapsOf(FormattableString.Invariant($"24 19 {west} 3 3"))[0];
        GridWindow window = fine.Window;
        (int line, int sample) = (window.FirstLine + 30, window.FirstSample + 30);
        NestedTerrain terrain = new([coarse, new GridWithGaps(fine, (atLine, atSample) => atLine == line && atSample == sample)]);

        double radius = TerrainHeight.RadiusBelow(terrain, fine.Projection.DirectionOf(line, sample));

        Assert.Equal(isFilled, radius != MoonConstants.ReferenceRadius);
    }

    [Fact]
    public void Misfits_OfMapsThatLieOnNone_AreNone()
    {
        Assert.Null(Assert.Single(new NestedTerrain(MapsOf("6 20 30 5 8; 6 20 38 5 8")).BorderMisfits()));
        Assert.NotNull(Assert.Single(new NestedTerrain(MapsOf("6 20 30 5 8; 24 19 34 3 3")).BorderMisfits()));
    }

    [Fact]
    public void Offset_ToMeetNothing_IsRefused()
    {
        ITerrainGrid[] models = MapsOf("6 20 30 5 8; 6 20 38 5 8");
        Assert.Contains(
            "and there are none", Assert.Throws<BadInputException>(() => AutomaticOffset.Of(models, _ => true)).Message,
            StringComparison.Ordinal);
    }

    private static ITerrainGrid[] MapsOf(string maps) => [.. Read(maps).Select(ITerrainGrid (map) => new WindowGrid(
        FunctionGrid.Rugged((int)map[0]),
        new GridWindow(
            (int)(map[0] * (90.0 - map[1])), (int)(map[0] * (90.0 - map[1] + map[3])), (int)(map[0] * map[2]),
            (int)(map[0] * (map[2] + map[4])))))];

    private static double[][] Read(string maps) =>
        [.. maps.Split(';').Select(map => map.Split(' ', StringSplitOptions.RemoveEmptyEntries)
            .Select(word => double.Parse(word, System.Globalization.CultureInfo.InvariantCulture)).ToArray())];

    private static double NorthOf(ITerrainGrid map) => LatitudeOf(map, map.Window.FirstLine - 3);

    private static double SouthOf(ITerrainGrid map) => LatitudeOf(map, map.Window.EndLine + 3);

    private static double LatitudeOf(ITerrainGrid map, int line) => SelenographicPoint.Below(map.Projection.DirectionOf(line, 0)).Latitude;

    private static double Degrees(double radians) => double.RadiansToDegrees(radians);

    private static (double West, double East) LongitudesOf(string maps)
    {
        double[][] read = Read(maps);
        bool isAcross = read.Any(map => map[2] > 300.0);
        return (read.Min(map => isAcross && map[2] > 300.0 ? map[2] - 360.0 : map[2]) - 1.0,
            read.Max(map => (isAcross && map[2] > 300.0 ? map[2] - 360.0 : map[2]) + map[4]) + 1.0);
    }

    /// <summary>Whether a place lies on a map or between two that touch: all places two cells around are on maps.</summary>
    private static bool IsWithin(string maps, double latitude, double longitude) =>
        Around(maps, latitude, longitude).All(place => Covers(maps, place.Latitude, place.Longitude));

    private static bool IsOutside(string maps, double latitude, double longitude) =>
        !Around(maps, latitude, longitude).Any(place => Covers(maps, place.Latitude, place.Longitude));

    private static IEnumerable<(double Latitude, double Longitude)> Around(string maps, double latitude, double longitude)
    {
        double reach = 2.0 / Read(maps).Min(map => map[0]);
        return from down in (double[])[-reach, 0.0, reach]
               from right in (double[])[-reach, 0.0, reach]
               select (latitude + down, longitude + right);
    }

    private static bool Covers(string maps, double latitude, double longitude) => Read(maps).Any(map =>
        latitude <= map[1] && latitude >= map[1] - map[3]
        && ((double[])[longitude, longitude + 360.0]).Any(at => at >= map[2] && at <= map[2] + map[4]));
}
