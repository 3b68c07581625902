using System.Globalization;
using System.Text.RegularExpressions;
using Msisf.Adapters.Scene;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Xunit;

namespace Msisf.Adapters.Tests.Scene;

public sealed class PovSceneWriterTests
{
    private static readonly PinholeCamera Camera = new(
        new Vector3D(2e6, 2e6, 1.0 / 3.0),
        UnitQuaternion.FromComponents(-2.391176183943345e-001, 9.904576054128762e-002, 3.696438106143861e-001, 8.923991008325228e-001),
        40.0 * Math.PI / 180.0,
        1024,
        768);

    private static readonly SceneLight Sun = new(new Vector3D(1.07495547328088e11, -1.04243073487898e11, 4.03616430556126e9), IsSun: true);

    [Theory]
    [InlineData("location")]
    [InlineData("right")]
    [InlineData("up")]
    [InlineData("direction")]
    public void Write_CameraVectors_ComeBackToTheLastDigit(string name)
    {
        Vector3D expected = name switch
        {
            "location" => Camera.PositionBodyFixed / 1000.0,
            "right" => Camera.Right,
            "up" => Camera.Up,
            _ => Camera.Direction,
        };

        Vector3D actual = VectorAfter(name, Write(Sun));

        Assert.Equal(expected, actual);
    }

    [Fact]
    public void Write_Sun_IsInKilometresAndGlows()
    {
        string scene = Write(Sun);

        Assert.Equal(Sun.PositionBodyFixed / 1000.0, VectorAfter(@"light_source\s*\{\s*", scene));
        Assert.Contains("looks_like", scene, StringComparison.Ordinal);
    }

    [Fact]
    public void Write_LampAtTheCamera_HasNoDisc()
    {
        string scene = Write(new SceneLight(Camera.PositionBodyFixed, IsSun: false));

        Assert.Equal(Camera.PositionBodyFixed / 1000.0, VectorAfter(@"light_source\s*\{\s*", scene));
        Assert.DoesNotContain("looks_like", scene, StringComparison.Ordinal);
    }

    [Fact]
    public void Write_Tiles_AreIncludedByFileNameInOrder()
    {
        string[] includes = [.. Regex.Matches(Write(Sun), "#include \"(.*)\"").Select(match => match.Groups[1].Value)];

        Assert.Equal(["lat_-5_0_lon_355_360.inc", "lat_0_5_lon_0_5.inc"], includes);
    }

    /// <summary>Patterns of blocks are moved by what the scene declares; so are its camera, its Sun and its map.</summary>
    [Fact]
    public void Write_OtherAxes_AreDeclaredAndUsed()
    {
        Vector3D origin = new(2e6, 1e6, -500.0);
        using StringWriter writer = new();
        PovSceneWriter.Write(
            writer,
            new RenderScene(Camera, Sun, "many", ["block.inc"], new SceneAlbedo("map.png", 0.0, 16, 0.7)) { Axes = new(origin, 4.0) });
        string scene = writer.ToString();

        Assert.Equal(origin / 1000.0, VectorAfter("#declare Origin =", scene));
        Assert.Contains("#declare UnitsPerKilometre = 4;\n", scene, StringComparison.Ordinal);
        Assert.Equal((Camera.PositionBodyFixed - origin) / 250.0, VectorAfter("location", scene));
        Assert.Equal((Sun.PositionBodyFixed - origin) / 250.0, VectorAfter(@"light_source\s*\{\s*", scene));
        Assert.Matches(@"rotate <0, 0, 0>\s*translate -Origin\s*scale UnitsPerKilometre\s*\}", scene);
        Assert.Matches(@"sphere\s*\{\s*0, 4000\s", scene);
    }

    [Fact]
    public void Write_KilometresFromTheMoonsCentre_DeclareNothing() =>
        Assert.DoesNotContain("Origin", Write(Sun), StringComparison.Ordinal);

    [Fact]
    public void Write_Lines_EndWithLineFeedOnly()
    {
        string scene = Write(Sun);

        Assert.DoesNotContain('\r', scene);
        Assert.EndsWith("\n", scene, StringComparison.Ordinal);
    }

    private static string Write(SceneLight light)
    {
        using StringWriter writer = new();
        PovSceneWriter.Write(writer, new RenderScene(Camera, light, "4", ["lat_-5_0_lon_355_360.inc", "lat_0_5_lon_0_5.inc"]));
        return writer.ToString();
    }

    private static Vector3D VectorAfter(string pattern, string scene)
    {
        Match match = Regex.Match(scene, pattern + @"\s*<(?<x>[^,]*), (?<y>[^,]*), (?<z>[^>]*)>");
        double Component(string name) => double.Parse(match.Groups[name].Value, CultureInfo.InvariantCulture);
        return new Vector3D(Component("x"), Component("y"), Component("z"));
    }
}
