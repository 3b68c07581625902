using System.Text.Json;
using Msisf.Adapters.Navigation;
using Msisf.Core.Camera;
using Msisf.Core.Navigation;
using Msisf.Core.Numerics;
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
        Assert.Equal(65.0 * Math.PI, annotation.GetProperty("area").GetDouble(), Rounding.OfChains);
        double[] polygon = [.. annotation.GetProperty("segmentation")[0].EnumerateArray().Select(number => number.GetDouble())];
        (double X, double Y)[] corners = [.. polygon.Chunk(2).Select(pair => (pair[0], pair[1]))];
        Assert.Equal(2, corners.Count(corner => corner.X == 0.0)); // where the border cuts it
        Assert.All(corners, corner => Assert.True(
            corner.X == 0.0 || Math.Abs(double.Hypot(corner.X - 2.5, corner.Y - 19.5) - 10.0) < Rounding.OfPlaces, $"{corner}"));
        Assert.InRange(AreaOf(corners), 0.97 * Segment(), Segment()); // 32 corners of a circle have 0.994 of its area
    }

    [Fact]
    public void Write_Crater_HasImageCategoryAndItsNumbers()
    {
        JsonElement written = Written(new ImageEllipse(40.0, 20.0, 10.0, 5.0, 0.5), inside: 1.0);
        JsonElement annotation = written.GetProperty("annotations")[0];
        JsonElement crater = annotation.GetProperty("crater");

        Assert.Equal("""{"id":3,"width":64,"height":48,"file_name":"a.png"}""", written.GetProperty("images")[0].GetRawText());
        Assert.Equal("""{"id":1,"name":"crater","supercategory":"landform"}""", written.GetProperty("categories")[0].GetRawText());
        Assert.Equal((7, 3, 1), (Of("id"), Of("image_id"), Of("category_id")));
        Assert.Equal("06-1-000123", crater.GetProperty("id").GetString());
        Assert.Equal("Kepler", crater.GetProperty("name").GetString());
        Assert.Equal(29_490.0, crater.GetProperty("diameter").GetDouble());
        Assert.Equal(JsonValueKind.Null, crater.GetProperty("hidden").ValueKind);

        int Of(string name) => annotation.GetProperty(name).GetInt32();
    }

    private static JsonElement Written(ImageEllipse ellipse, double inside)
    {
        CraterView view = new(Kepler, CraterDisc.Of(Kepler, 1_737_400.0), ellipse) { Inside = inside, Emission = 0.1, Incidence = 0.2 };
        PinholeCamera camera = new(new Vector3D(2e6, 0.0, 0.0), UnitQuaternion.Identity, 0.5, 64, 48);
        CratersOfFrame craters = new([view], [], 0) { LeastDiameter = 6.0, Rim = CraterRim.Disc };
        using MemoryStream stream = new();
        CocoWriter.Write(stream, craters, camera, (3, "a.png"), 1_737_400.0);
        Assert.Equal((byte)'\n', stream.ToArray()[^1]);
        return JsonDocument.Parse(stream.ToArray()).RootElement;
    }

    /// <summary>px^2 of the circle's part to the right of the border, 2.5 px left of its centre.</summary>
    private static double Segment() => (100.0 * (Math.PI - Math.Atan2(Math.Sqrt(93.75), 2.5))) + (2.5 * Math.Sqrt(93.75));

    private static double AreaOf((double X, double Y)[] corners) => 0.5 * Math.Abs(corners.Zip(
        corners.Skip(1).Append(corners[0]), (from, to) => (from.X * to.Y) - (to.X * from.Y)).Sum());
}
