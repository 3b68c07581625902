using System.Text.Json;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests.Modules;

/// <summary>wwwroot/js/models.js, contours.js, names.js, text.js, trajectory.js, pins.js, sphere.js: values counted by hand.</summary>
[Collection(Chromium.Collection)]
public class InstrumentTests(ModulePage page) : IClassFixture<ModulePage>
{
    private static readonly object[] Models =
    [
        new { name = "LDEM_64", whole_moon = true, metres_per_pixel = 473.8 },
        new { name = "LDEM_4", whole_moon = true, metres_per_pixel = 7580.8 },
        new { name = "LDEM_80S_20M", whole_moon = false, metres_per_pixel = 20.0 },
        new { name = "LDEM_16", whole_moon = true, metres_per_pixel = 1895.2 },
    ];

    /// <summary>The coarsest whose cells are below two pixels.</summary>
    [RequiresTheory(Part.Chromium)]
    [InlineData(4000.0, "LDEM_4")]
    [InlineData(3790.0, "LDEM_16")]
    [InlineData(948.0, "LDEM_16")]
    [InlineData(947.0, "LDEM_64")]
    [InlineData(1.0, "LDEM_64")]
    public async Task ModelFor_PixelsOfASize_IsTheCoarsestThatIsFineEnough(double metres, string name) =>
        Assert.Equal(name, (await page.CallAsync("models", "modelFor", Models, metres)).GetProperty("name").GetString());

    /// <summary>From 100 km straight down, a tenth of a radian of 1000 px is 10 m a pixel; beside the Moon it is the limb's.</summary>
    [RequiresFact(Part.Chromium)]
    public async Task PixelSize_StraightDown_IsTheHeightTimesTheAngle()
    {
        double fov = double.RadiansToDegrees(2.0 * Math.Atan(0.05));
        object view = new { latitude = 12, longitude = 300, altitude = 100_000, heading = 30, tilt = 0, roll = 0, fov };

        JsonElement size = await page.CallAsync("models", "pixelSize", view, new { width = 1000, height = 500 });

        Assert.Equal(10.0, size.GetDouble(), 1e-6);
    }

    /// <summary>A plane that rises by 10 a pixel to the right: each level is an upright line.</summary>
    [RequiresFact(Part.Chromium)]
    public async Task SegmentsOf_APlane_AreALineWhereItHasTheLevel()
    {
        object plane = new { width = 4, height = 3, values = new[] { 0, 10, 20, 30, 0, 10, 20, 30, 0, 10, 20, 30 } };

        JsonElement segments = await page.CallAsync("contours", "segmentsOf", plane, 14);

        Assert.Equal(2, segments.GetArrayLength());
        Assert.All(segments.EnumerateArray(), segment => Assert.Equal(2.4, segment[0].GetDouble(), Rounding.OfChains));
        Assert.All(segments.EnumerateArray(), segment => Assert.Equal(2.4, segment[2].GetDouble(), Rounding.OfChains));
        Assert.Equal([1.0, 2.0, 2.0, 3.0], segments.EnumerateArray().SelectMany(
            segment => new[] { segment[1].GetDouble(), segment[3].GetDouble() }).Order());
    }

    [RequiresTheory(Part.Chromium)]
    [InlineData("wafa", "Abul Wáfa")]
    [InlineData("mare c", "Mare Crisium|Mare Cognitum")]
    [InlineData("crisium", "Mare Crisium")]
    [InlineData("x", "")]
    public async Task Find_ANameByItsBeginningOrAWord_IgnoresAccents(string text, string found)
    {
        object[] names =
        [
            new { name = "Mare Cognitum", diameter = 350e3 }, new { name = "Mare Crisium", diameter = 556e3 },
            new { name = "Abul Wáfa", diameter = 54e3 },
        ];

        JsonElement list = await page.CallAsync("names", "find", names, text);

        Assert.Equal(found, string.Join('|', list.EnumerateArray().Select(feature => feature.GetProperty("name").GetString())));
    }

    [RequiresTheory(Part.Chromium)]
    [InlineData("43.3 S 11.2 W", -43.3, 348.8)]
    [InlineData("-43.3, 348.8", -43.3, 348.8)]
    [InlineData("0.5°N, 10°E", 0.5, 10.0)]
    public async Task PlaceOfText_Numbers_IsThePlace(string text, double latitude, double longitude)
    {
        JsonElement place = await page.CallAsync("text", "placeOfText", text);

        Assert.Equal(latitude, place.GetProperty("latitude").GetDouble(), Rounding.OfPlaces);
        Assert.Equal(longitude, place.GetProperty("longitude").GetDouble(), Rounding.OfPlaces);
    }

    [RequiresTheory(Part.Chromium)]
    [InlineData("95 N 0 E")]
    [InlineData("Tycho")]
    [InlineData("12")]
    public async Task PlaceOfText_NoPlace_IsNone(string text) =>
        Assert.Equal(JsonValueKind.Null, (await page.CallAsync("text", "placeOfText", text)).ValueKind);

    [RequiresTheory(Part.Chromium)]
    [InlineData(348.8, false, "348.800° E")]
    [InlineData(348.8, true, "11.200° W")]
    [InlineData(10.0, true, "10.000° E")]
    public async Task LongitudeText_AsChosen_IsEastOrBothWays(double longitude, bool isHalved, string text) =>
        Assert.Equal(text, (await page.CallAsync("text", "longitudeText", longitude, 3, isHalved)).GetString());

    [RequiresTheory(Part.Chromium)]
    [InlineData("--kepler-set '{1.9E6,0.05,0.7,1.1,0.9,2.0}'", "[1900000,0.05,0.7,1.1,0.9,2]")]
    [InlineData("{1, 2, 3}", "null")]
    [InlineData("{1.9e6,0,0,0,0,}", "null")]
    public async Task KeplerOf_AText_IsItsSixNumbers(string text, string numbers) =>
        Assert.Equal(numbers, (await page.CallAsync("trajectory", "keplerOf", text)).GetRawText());

    /// <summary>From the equator to the pole: half way is at 45 degrees.</summary>
    [RequiresFact(Part.Chromium)]
    public async Task WayAlong_EquatorAndPole_IsEven()
    {
        object[] points = [new[] { 1.0, 0.0, 0.0 }, new[] { 0.0, 0.0, 2.0 }];
        JsonElement way = await page.CallAsync("pins", "wayAlong", points, 5);

        Assert.Equal([0.0, 22.5, 45.0, 67.5, 90.0], way.EnumerateArray().Select(place => Math.Round(place[0].GetDouble(), 9)));
    }

    /// <summary>30 degrees east along the equator, then 60 north: in steps of 15 degrees round the corner, to the very end.</summary>
    [RequiresFact(Part.Chromium)]
    public async Task WayAlong_ThreePoints_GoesRoundTheCornerEvenly()
    {
        (double sine, double cosine) = Math.SinCos(double.DegreesToRadians(30.0));
        object[] points = [new[] { 1.0, 0.0, 0.0 }, new[] { cosine, sine, 0.0 }, new[] { cosine / 2.0, sine / 2.0, Math.Sqrt(0.75) }];
        JsonElement way = await page.CallAsync("pins", "wayAlong", points, 7);

        Assert.Equal([0.0, 0.0, 0.0, 15.0, 30.0, 45.0, 60.0], way.EnumerateArray().Select(place => Math.Round(place[0].GetDouble(), 9)));
        Assert.Equal([0.0, 15.0, 30.0, 30.0, 30.0, 30.0, 30.0], way.EnumerateArray().Select(place => Math.Round(place[1].GetDouble(), 9)));
    }

    /// <summary>The hour of the first light that shows the ground, by hand.</summary>
    [RequiresTheory(Part.Chromium)]
    [InlineData("[0, 0, 0.4, 1, 1, 1]", "[-2, 1, 3, 4, 5, 6]", 4)] // 5 degrees high, and in view
    [InlineData("[0, 0, 0, 0, 0, 1]", "[1, 6, 7, 8, 9, 9.5]", 5)] // mountains hide it before
    [InlineData("[0, 1, 1, 1, 0, 0]", "[0, 1, 1.5, 1.2, 7, 8]", 2)] // in the light it stays low: where it is highest
    [InlineData("[0, 0, 0.1, 0, 0, 0]", "[9, 9, 9, 9, 9, 9]", -1)]
    public async Task FirstLight_PartsAndElevations_IsTheHourThatShowsTheGround(string parts, string elevations, int hour)
    {
        double[][] lists = [.. new[] { parts, elevations }.Select(text => JsonSerializer.Deserialize<double[]>(text)!)];
        Assert.Equal(hour, (await page.CallAsync("light", "firstLight", lists[0], lists[1])).GetInt32());
    }

    /// <summary>The sphere before the first picture: under the Sun of SPICE to 10 degrees.</summary>
    [RequiresTheory(Part.Chromium)]
    [InlineData(55307.0, 96.1)]
    [InlineData(55300.0, 181.7)]
    public async Task AboutSun_KnownDays_IsNearTheSubSolarPoint(double mjd, double longitude)
    {
        JsonElement sun = await page.CallAsync("sphere", "aboutSun", mjd);

        double found = double.RadiansToDegrees(Math.Atan2(sun[1].GetDouble(), sun[0].GetDouble()));
        Assert.InRange(Math.Abs(Math.IEEERemainder(found - longitude, 360.0)), 0.0, 10.0);
    }
}
