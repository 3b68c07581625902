using System.Globalization;
using System.Text.Json;
using Msisf.Adapters.Navigation;
using Msisf.Core.Camera;
using Msisf.Core.Navigation;
using Msisf.Core.Numerics;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Navigation;

public sealed class CocoWriterTests
{
    private static readonly Crater Kepler = new(7, "06-1-000123", "Kepler", 8.1, -38.0, 29_490.0);

    /// <summary>A circle of 10 px about (3, 20), which is (2.5, 19.5) from the corner of the image.</summary>
    [Fact]
    public void Write_CircleOverTheLeftBorder_IsCutOffThere()
    {
        JsonElement annotation = Written(new ImageEllipse(3.0, 20.0, 10.0, 10.0, 0.0), inside: 0.65).GetProperty("annotations")[0];

        Assert.Equal([0.0, 9.5, 12.5, 20.0], annotation.GetProperty("bbox").EnumerateArray().Select(number => number.GetDouble()));
        double[] polygon = [.. annotation.GetProperty("segmentation")[0].EnumerateArray().Select(number => number.GetDouble())];
        (double X, double Y)[] corners = [.. polygon.Chunk(2).Select(pair => (pair[0], pair[1]))];
        Assert.Equal(2, corners.Count(corner => corner.X == 0.0)); // where the border cuts it
        Assert.All(corners, corner => Assert.True(
            corner.X == 0.0 || Math.Abs(double.Hypot(corner.X - 2.5, corner.Y - 19.5) - 10.0) < 0.001, $"{corner}")); // as it is rounded
        Assert.Equal(Segment(), annotation.GetProperty("area").GetDouble(), 0.004 * Segment());
    }

    /// <summary>A circle of 10 px about (-6, 20): its widest place is outside, and what is inside is lower than the circle.</summary>
    [Fact]
    public void Write_CircleWithItsCentreOutside_HasTheBoxOfThePartInside()
    {
        JsonElement annotation = Written(new ImageEllipse(-5.5, 20.5, 10.0, 10.0, 0.0), inside: 0.14).GetProperty("annotations")[0];

        Assert.Equal([0.0, 12.0, 4.0, 16.0], annotation.GetProperty("bbox").EnumerateArray().Select(number => number.GetDouble()));
    }

    /// <summary>Any ellipse, of 1 to 1,000 px and cut by none to four borders: an independent reader finds no fault.</summary>
    [Fact]
    public void Write_AnyEllipses_KeepTheRulesOfTheFormat()
    {
        Random random = new(20120222);
        using TemporaryFolder folder = new();
        int annotations = 0;
        int cut = 0;
        for (int number = 0; number < TestLength.Of(40, 2000); number++)
        {
            double major = Math.Exp(7.0 * random.NextDouble());
            ImageEllipse ellipse = new(
                (100.0 * random.NextDouble()) - 18.0, (80.0 * random.NextDouble()) - 16.0, major,
                major * (0.05 + (0.95 * random.NextDouble())),
                Math.PI * (random.NextDouble() - 0.5));
            File.WriteAllBytes(folder["a.json"], Bytes(ellipse, ellipse.AreaInside(64, 48) / ellipse.Area));
            CocoRules rules = CocoRules.Check(folder["a.json"]);
            (annotations, cut) = (annotations + rules.Annotations, cut + rules.CutInside);
        }

        Assert.InRange(annotations, 15, int.MaxValue);
        Assert.InRange(cut, 1, annotations); // of these the cut box of the whole ellipse is another one
    }

    [Theory]
    [InlineData(80.0, 20.0, 10.0)] // outside
    [InlineData(-9.4, 20.0, 10.0)] // 0.1 px of it inside
    [InlineData(30.0, 20.0, 0.5)] // smaller than a pixel
    public void Write_Sliver_IsLeftOut(double x, double y, double radius) =>
        Assert.Empty(Written(new ImageEllipse(x, y, radius, radius, 0.0), inside: 0.001).GetProperty("annotations").EnumerateArray());

    [Theory]
    [InlineData(0.2, 0.5, 0)]
    [InlineData(0.6, 0.5, 1)]
    [InlineData(0.2, 0.05, 1)]
    [InlineData(null, null, 1)]
    public void Write_HiddenOrUnlitCrater_IsMarked(double? hidden, double? lit, int ignore)
    {
        JsonElement written = Written(new ImageEllipse(40.0, 20.0, 10.0, 5.0, 0.5), inside: 1.0, hidden, lit);

        Assert.Equal(ignore, written.GetProperty("annotations")[0].GetProperty("ignore").GetInt32());
    }

    [Fact]
    public void Write_Crater_HasImageCategoryAndItsNumbers()
    {
        JsonElement written = Written(new ImageEllipse(40.0, 20.0, 10.0, 5.0, 0.5), inside: 1.0);
        JsonElement annotation = written.GetProperty("annotations")[0];
        JsonElement crater = annotation.GetProperty("crater");

        Assert.Equal(
            """{"id":3,"width":64,"height":48,"file_name":"a.png","license":1,"date_captured":"2010-04-03 12:00:00"}""",
            written.GetProperty("images")[0].GetRawText());
        Assert.Equal("""{"id":1,"name":"crater","supercategory":"landform"}""", written.GetProperty("categories")[0].GetRawText());
        Assert.Equal("""[{"id":1,"name":"CC0","url":""}]""", written.GetProperty("licenses").GetRawText());
        Assert.Equal((7, 3, 1), (Of("id"), Of("image_id"), Of("category_id")));
        Assert.Equal("06-1-000123", crater.GetProperty("id").GetString());
        Assert.Equal("Kepler", crater.GetProperty("name").GetString());
        Assert.Equal(29_490.0, crater.GetProperty("diameter").GetDouble());
        Assert.Equal(JsonValueKind.Null, crater.GetProperty("hidden").ValueKind);

        int Of(string name) => annotation.GetProperty(name).GetInt32();
    }

    /// <summary>An angle that is known to 2 degrees, and goes with the centre: covariances are in degrees, as 'turn' is.</summary>
    [Fact]
    public void Write_Covariance_HasTheUnitsOfItsColumns()
    {
        double[] covariance = new double[25];
        covariance[24] = double.DegreesToRadians(2.0) * double.DegreesToRadians(2.0);
        covariance[4] = covariance[20] = 3.0 * double.DegreesToRadians(2.0);
        CraterView view = View(new ImageEllipse(40.0, 20.0, 10.0, 5.0, 0.5), 1.0) with
        {
            Covariance = covariance,
            Crater = Kepler with { Errors = new CraterErrors(0.0, 0.0, 0.0, 0.0, 2.0) },
        };
        using StringWriter csv = new();
        NavigationCsvWriter.Write(csv, new CratersOfFrame([view], [], 0) { LeastDiameter = 6.0, Rim = CraterRim.Disc }, 1_737_400.0);
        string[][] lines = [.. csv.ToString().TrimEnd().Split('\n').Select(line => line.Split(','))];

        Assert.Equal(4.0, Value("cov_turn_turn"), 1e-12);
        Assert.Equal(6.0, Value("cov_h_turn"), 1e-12);
        Assert.Equal(0.0, Value("cov_h_h"));

        double Value(string name) => double.Parse(lines[1][Array.IndexOf(lines[0], name)], CultureInfo.InvariantCulture);
    }

    private static CraterView View(ImageEllipse ellipse, double inside) =>
        new(Kepler, CraterDisc.Of(Kepler, 1_737_400.0), ellipse) { Inside = inside, Emission = 0.1, Incidence = 0.2 };

    private static JsonElement Written(ImageEllipse ellipse, double inside, double? hidden = null, double? lit = null)
    {
        byte[] written = Bytes(ellipse, inside, hidden, lit);
        Assert.Equal((byte)'\n', written[^1]);
        return JsonDocument.Parse(written).RootElement;
    }

    private static byte[] Bytes(ImageEllipse ellipse, double inside, double? hidden = null, double? lit = null)
    {
        CraterView view = View(ellipse, inside) with { Hidden = hidden, Lit = lit };
        PinholeCamera camera = new(new Vector3D(2e6, 0.0, 0.0), UnitQuaternion.Identity, 0.5, 64, 48);
        CratersOfFrame craters = new([view], [], 0) { LeastDiameter = 6.0, Rim = CraterRim.Disc };
        using MemoryStream stream = new();
        CocoWriter.Write(
            stream, craters, camera, new CocoSource("A test", "1.0", ["CC0"]),
            new CocoImage(3, "a.png", Moments.OfMjd(55289.5)), 1_737_400.0);
        return stream.ToArray();
    }

    /// <summary>px^2 of the circle's part to the right of the border, 2.5 px left of its centre.</summary>
    private static double Segment() => (100.0 * (Math.PI - Math.Atan2(Math.Sqrt(93.75), 2.5))) + (2.5 * Math.Sqrt(93.75));
}
