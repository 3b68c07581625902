using System.Globalization;
using Msisf.Core.Attitude;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;
using Xunit.Abstractions;

namespace Msisf.Integration.Tests.Run;

/// <summary>
/// The native renderer's images of the real Moon against POV-Ray's of the same facets, without antialiasing. POV-Ray keeps vertices and
/// rays' hits with other rounding, so a pixel whose ray passes close by an edge may fall to its other side: such a pixel is allowed if the
/// other image has its value within one pixel, and few of them are.
/// </summary>
public sealed class NativeImageTests(ITestOutputHelper output) : IDisposable
{
    private const int Side = 384;

    /// <summary>1: part of the pixels that may lie at the other side of an edge.</summary>
    private const double EdgePixels = 0.001;

    /// <summary>Grey levels of 255: the two round the same brightness.</summary>
    private const int SameGrey = 1;

    /// <summary>1: part of the pixels where POV-Ray's ray slips between two triangles; its 12 from 1e9 m are the most seen.</summary>
    private const double PovRayLeaks = 0.0002;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>Lit from the camera, all that is not black is the surface.</summary>
    [RequiresTheory(Part.Ldem4, Part.PovRay)]
    [InlineData("whole disc over the seam", 6e6, -1e5, 1e6, "40")]
    [InlineData("limb over the pole", 2e5, 1e5, 2.4e6, "100")]
    [InlineData("half the disc, 1e9 m away", 8e8, 5e8, -3e8, "0.15")]
    public void Silhouette_IsPovRaysWithinAPixel(string name, double x, double y, double z, string fieldOfView)
    {
        (PngPixels povRay, PngPixels native) = RenderBoth(Nadir(new Vector3D(x, y, z)), "--fov", fieldOfView, "--ignore-sun");

        ImageDifference difference = new(povRay, native, SameGrey);

        output.WriteLine($"{name}: {difference}");
        Assert.True(difference.OffEdge.Count == 0, $"{name}: {difference}");
        Assert.True(difference.BlackDiffers <= EdgePixels * Side * Side, $"{name}: {difference}");
        Assert.True(difference.Leaks <= PovRayLeaks * Side * Side, $"{name}: {difference}");
        Assert.InRange(difference.Black, Side, Side * Side / 2);
    }

    [RequiresTheory(Part.Ldem4, Part.PovRay)]
    [InlineData("low Sun over the north pole", 1e5, 2e5, 1.9e6, "40")]
    [InlineData("Sun 5 degrees high, 100 km over the seam at 85 N", 160_138.8, 0.0, 1_830_411.0, "60")]
    [InlineData("terminator at 20 km", 1.255e6, 1.225e6, 5e4, "70")]
    public void LightAndShadow_LookingDown_ArePovRays(string name, double x, double y, double z, string fieldOfView) =>
        AssertSameLight(name, Nadir(new Vector3D(x, y, z)), "--fov", fieldOfView);

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void LightAndShadow_Section92_ArePovRays() => AssertSameLight(
        "section 9.2",
        "{55289,2E6,2E6,0,-2.391176183943345e-001,+9.904576054128762e-002,+3.696438106143861e-001,+8.923991008325228e-001}");

    /// <summary>Where a pixel of the map spans several of the image, both renderers show it linear between its pixels.</summary>
    [RequiresTheory(Part.Ldem4, Part.PovRay)]
    [InlineData("over the seam at 20 N", -1.74e6, -1e3, 6.3e5)]
    [InlineData("over the map's left edge", 1.74e6, 1e3, -6.3e5)]
    [InlineData("over 60 N", 9.25e5, 1e3, 1.602e6)]
    public void Albedo_LambertWithAMap_IsPovRays(string name, double x, double y, double z)
    {
        string map = PdsMap.Write(
            _folder, "WAC_EMP_643NM_TEST", "UNSIGNED_INTEGER", 8, 2, (column, row) => 40 + ((73 * column) + (41 * row)) % 200,
            "SCALING_FACTOR = 0.004");

        (PngPixels povRay, PngPixels native) = RenderBoth(
            Nadir(new Vector3D(x, y, z)), "--fov", "60", "--ignore-sun", "--albedo-map", map);

        ImageDifference difference = new(povRay, native, SameGrey);
        output.WriteLine($"{name}: {difference}");
        Assert.True(difference.OffEdge.Count == 0, $"{name}: {difference}");
        Assert.True(difference.BlackDiffers + difference.GreyDiffers <= EdgePixels * Side * Side, $"{name}: {difference}");
    }

    /// <summary>
    /// Beside a pole a pixel covers many columns of the map and a part of a row: the rows must not be blurred with the columns, nor those
    /// of the other pole be met.
    /// </summary>
    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Albedo_OverThePole_IsPovRays()
    {
        string map = PdsMap.Write(
            _folder, "WAC_EMP_643NM_TEST", "UNSIGNED_INTEGER", 8, 2,
            (column, row) => row < 180
                ? 60 + (5 * Math.Min(row, 20)) + Math.Round(Math.Min(row, 8) * Math.Sin(Math.PI * column / 120.0))
                : 250,
            "SCALING_FACTOR = 0.004");

        (PngPixels povRay, PngPixels native) = RenderBoth(
            Nadir(new Vector3D(1.0, 1.0, 1.84e6)), "--fov", "20", "--ignore-sun", "--albedo-map", map);

        ImageDifference difference = new(povRay, native, SameGrey);
        output.WriteLine($"{difference}");
        Assert.True(difference.OffEdge.Count == 0, $"{difference}");
        Assert.True(difference.BlackDiffers + difference.GreyDiffers <= EdgePixels * Side * Side, $"{difference}");
    }

    /// <summary>Over the place where four of eight tiles meet.</summary>
    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Albedo_MapInTiles_HasTheImagesOfOneFile()
    {
        static double Value(int column, int row) => 40 + (((73 * column) + (41 * row)) % 200);
        string state = Nadir(new Vector3D(1e3, 2.2e6, 1e3));
        using TemporaryFolder tiles = new();
        PdsMapTiles.WriteEight(tiles, "WAC_EMP_643NM", ("UNSIGNED_INTEGER", 8), 2, 90, Value, "SCALING_FACTOR = 0.004");
        string file = PdsMap.Write(_folder, "WAC_EMP_643NM", "UNSIGNED_INTEGER", 8, 2, Value, "SCALING_FACTOR = 0.004");
        (PngPixels PovRay, PngPixels Native) one = RenderBoth(state, "--fov", "30", "--ignore-sun", "--albedo-map", file);

        (PngPixels PovRay, PngPixels Native) many = RenderBoth(state, "--fov", "30", "--ignore-sun", "--albedo-map", tiles.Path);

        Assert.Equal(one.PovRay.ChannelParts(0), many.PovRay.ChannelParts(0));
        Assert.Equal(one.Native.ChannelParts(0), many.Native.ChannelParts(0));
        string meta = File.ReadAllText(_folder["native.xml"]);
        Assert.All(Directory.GetFiles(tiles.Path), tile => Assert.Contains(
            $"<Input kind=\"albedo-map\" name=\"{Path.GetFileName(tile)}\"", meta, StringComparison.Ordinal));
    }

    private void AssertSameLight(string name, string state, params string[] more)
    {
        (PngPixels povRay, PngPixels native) = RenderBoth(state, more);

        ImageDifference difference = new(povRay, native, SameGrey);
        output.WriteLine($"{name}: {difference}");
        Assert.True(difference.OffEdge.Count == 0, $"{name}: {difference}");
        Assert.True(difference.BlackDiffers + difference.GreyDiffers <= EdgePixels * Side * Side, $"{name}: {difference}");
        Assert.True(difference.Leaks <= PovRayLeaks * Side * Side, $"{name}: {difference}");
        Assert.InRange(difference.Black, Side * Side / 100, 99 * Side * Side / 100);
    }

    private static string Nadir(Vector3D position)
    {
        UnitQuaternion attitude = NadirPointing.MoonFromCamera(position);
        return string.Create(
            CultureInfo.InvariantCulture,
            $"{{55289,{position.X:R},{position.Y:R},{position.Z:R},{attitude.X:R},{attitude.Y:R},{attitude.Z:R},{attitude.W:R}}}");
    }

    private (PngPixels PovRay, PngPixels Native) RenderBoth(string state, params string[] more)
    {
        string side = Side.ToString(CultureInfo.InvariantCulture);
        string[] arguments = ["--fixed-state", state, "--width", side, "--height", side, .. more];
        string[] common = RealMoon.Arguments(_folder.Path);
        CommandLineRun povRay = CommandLineRun.Of(
            [.. arguments, "--output-name", "povray", "--lod", "off", "--pov-options", "Antialias=Off", .. common]);
        Assert.True(povRay.ExitCode == 0, povRay.Error);
        string[] withoutPatterns = [.. common.Where((_, index) => index is not (2 or 3))];
        CommandLineRun native = CommandLineRun.Of(
            [.. arguments, "--output-name", "native", "--renderer", "native", "--reflectance", "lambert", .. withoutPatterns]);
        Assert.True(native.ExitCode == 0, native.Error);
        return (PngPixels.Read(_folder["povray.png"]), PngPixels.Read(_folder["native.png"]));
    }
}
