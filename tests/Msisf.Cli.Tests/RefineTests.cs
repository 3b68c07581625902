using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>Invented detail below the elevation models, as a user has it.</summary>
public sealed class RefineTests : IDisposable
{
    private const string View = "--position=12,5,terrain+40000 --off-nadir 50,30 --time 2000-01-01T00:00:00Z --ignore-sun --batch "
        + "--width 40 --height 40 --fov 40";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Run_Refined_NamesTheInventedPartsInAllFiles()
    {
        CommandLineRun run = Draw(
            "a", "--ldem", Moon(), "--res", "2", "--refine", "7", "--refine-cell", "300", "--layers", "cell,tile,height",
            "--layers-format", "npy");

        Assert.Equal((0, string.Empty), (run.ExitCode, run.ExitCode == 0 ? string.Empty : run.Error));
        Assert.Contains(
            "INVENTED below the resolution of LDEM_2_SYNTHETIC, from seed 7, in cells of 256 m", run.Error, StringComparison.Ordinal);
        string xml = File.ReadAllText(Path.Combine(_folder["out"], "a.xml"));
        Assert.Contains("<ElevationPart part=\"0\" product=\"LDEM_2_SYNTHETIC\"", xml, StringComparison.Ordinal);
        Assert.Contains(
            "<ElevationPart part=\"1\" product=\"REFINE_7\" synthetic=\"yes\" resolution=\"4096\" drawn=\"4096\" unit=\"m/px\" />", xml,
            StringComparison.Ordinal);
        Assert.Contains("REFINE_7", MetaFileXml.Parse(xml).Descendants("ElevationPart").Select(part => part.Attribute("product")!.Value));
        Assert.Contains(" --refine 7 --refine-cell 256 ", xml, StringComparison.Ordinal);
        Assert.DoesNotContain("tile=", xml, StringComparison.Ordinal);
        Assert.Contains(
            "\"inventedDetail\": \"REFINE_7\"", File.ReadAllText(Path.Combine(_folder["out"], "a.layers.json")), StringComparison.Ordinal);
        byte[] cell = File.ReadAllBytes(Path.Combine(_folder["out"], "a.cell.npy"));
        Assert.Contains("'shape': (40, 40, 3,)", System.Text.Encoding.ASCII.GetString(cell, 0, 128), StringComparison.Ordinal);
        int start = cell.Length - (40 * 40 * 3 * 4);
        int[] parts = [.. Enumerable.Range(0, 1600).Select(pixel => BitConverter.ToInt32(cell, start + (12 * pixel) + 8)).Distinct()];
        Assert.True(parts.Count(part => part > 0) > 1, string.Join(' ', parts.Order()));
    }

    /// <summary>The command in the meta file makes the same image; another seed and no seed make others.</summary>
    [Fact]
    public void Run_SameSeed_GivesTheSameImage()
    {
        string moon = Moon();
        Assert.Equal(0, Draw("a", "--ldem", moon, "--res", "2", "--refine", "1").ExitCode);
        Assert.Equal(0, Draw("b", "--ldem", moon, "--res", "2", "--refine", "1", "--jobs", "3").ExitCode);
        Assert.Equal(0, Draw("c", "--ldem", moon, "--res", "2", "--refine", "2").ExitCode);
        Assert.Equal(0, Draw("d", "--ldem", moon, "--res", "2").ExitCode);
        byte[][] images = [.. new[] { "a", "b", "c", "d" }.Select(name => File.ReadAllBytes(Path.Combine(_folder["out"], $"{name}.png")))];
        Assert.Equal(images[0], images[1]);
        Assert.NotEqual(images[0], images[2]);
        Assert.NotEqual(images[0], images[3]);
    }

    /// <summary>A frame does not depend on those before it: drawn alone, it has the same bytes as in a descent.</summary>
    [Fact]
    public void Run_Series_HasTheImagesOfSingleFrames()
    {
        string moon = Moon();
        string[] places = ["12,5,terrain+60000", "12.1,5,terrain+30000", "12.15,5.3,terrain+14000", "12.2,5.3,terrain+13000"];
        string[] lines = ["time,lat,lon,height,off_nadir,azimuth", .. places.Select(place => $"2000-01-01T00:00:00Z,{place},50,30")];
        string[] options = ["--ldem", moon, "--res", "2", "--refine", "3", "--refine-cell", "64"];
        File.WriteAllLines(_folder["descent.csv"], lines);
        CommandLineRun run = Run(["--batch-file", _folder["descent.csv"], .. Rest, "--jobs", "2", .. options], "series-{step:00}");
        Assert.True(run.ExitCode == 0, run.Error);
        byte[][] series = [.. Directory.GetFiles(_folder["out"], "series-*.png").Order(StringComparer.Ordinal).Select(File.ReadAllBytes)];
        Assert.Equal(places.Length, series.Length);
        for (int frame = 0; frame < places.Length; frame++)
        {
            CommandLineRun alone = Run(
                [$"--position={places[frame]}", "--off-nadir", "50,30", "--time", "2000-01-01T00:00:00Z", .. Rest, .. options],
                $"alone-{frame}");
            Assert.True(alone.ExitCode == 0, alone.Error);
            Assert.Equal(File.ReadAllBytes(Path.Combine(_folder["out"], $"alone-{frame}.png")), series[frame]);
        }
    }

    /// <summary>
    /// The image has the rays that the layer tells. Lambert's law is the albedo times the cosine of the incidence, and 0 beyond a right
    /// angle.
    /// </summary>
    [Fact]
    public void Run_Refined_RaysScaleTheReflectance()
    {
        CommandLineRun run = Run(
            ["--position=12,5,terrain+400", "--time", "2000-01-01T00:00:00Z", "--ignore-sun", "--batch", "--width", "200", "--height",
             "200", "--fov", "40", "--renderer", "native", "--ldem", Moon(), "--res", "2", "--refine", "7", "--layers",
             "rays,incidence,radiance-factor", "--layers-format", "npy", "--reflectance", "lambert", "--albedo", "0.4"],
            "a");
        Assert.True(run.ExitCode == 0, run.Error);
        (double[] rays, double[] incidence) = (Doubles("a", "rays"), Doubles("a", "incidence"));
        double[] factors = Doubles("a", "radiance-factor");
        for (int i = 0; i < rays.Length; i++)
        {
            Assert.Equal(0.4 * Math.Max(0.0, Math.Cos(double.DegreesToRadians(incidence[i]))) * rays[i], factors[i], Rounding.OfChains);
        }

        Assert.True(rays.Max() > 1.2 && rays.Min() < 0.99, $"{rays.Min()} to {rays.Max()}");
    }

    /// <summary>
    /// A map of a site's own reflectance counts as it is, without invented rays; around it, in the same image, they are seen.
    /// </summary>
    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Run_SiteWithOwnMap_HasNoRaysThere()
    {
        const string Script = """
            import sys
            import numpy as np
            from osgeo import gdal, osr
            def write(path, width, height, west, north, pixel):
                data = gdal.GetDriverByName('GTiff').Create(path, width, height, 1, gdal.GDT_Float32)
                data.GetRasterBand(1).WriteArray(np.full((height, width), 0.25, 'f4'))
                data.SetGeoTransform([west, pixel, 0.0, north, 0.0, -pixel])
                system = osr.SpatialReference()
                system.ImportFromProj4('+proj=eqc +R=1737400 +units=m')
                data.SetProjection(system.ExportToWkt())
            degree = np.radians(1737400.0)
            write(sys.argv[1], 360, 180, -180 * degree, 90 * degree, degree)
            write(sys.argv[2], 200, 200, 5 * degree - 800, 12 * degree + 400, 4.0)
            """;
        (string moon, string site) = (_folder["moon.tif"], _folder["site.tif"]);
        ChildRun.Of(TestParts.Python!, ["-c", Script, moon, site], _folder.Path).Succeeded();
        CommandLineRun run = Run(
            ["--position=12,5,terrain+400", "--time", "2000-01-01T00:00:00Z", "--ignore-sun", "--batch", "--width", "200", "--height",
             "200", "--fov", "40", "--renderer", "native", "--ldem", Moon(), "--res", "2", "--refine", "7", "--layers",
             "rays,incidence,radiance-factor,longitude", "--layers-format", "npy", "--reflectance", "lambert", "--albedo-map",
             $"{moon},scale=1,incidence=0,emission=0,phase=0", "--albedo-map", $"{site},scale=1,incidence=0,emission=0,phase=0"],
            "a");
        Assert.True(run.ExitCode == 0, run.Error);
        (double[] rays, double[] incidence) = (Doubles("a", "rays"), Doubles("a", "incidence"));
        (double[] factors, double[] longitudes) = (Doubles("a", "radiance-factor"), Doubles("a", "longitude"));
        double[] albedos = [.. factors.Zip(incidence, (factor, angle) => factor / Math.Cos(double.DegreesToRadians(angle)))];
        int[] lit = [.. Enumerable.Range(0, rays.Length).Where(i => incidence[i] < 85.0 && Math.Abs(longitudes[i] - 5.0) > 1e-4)];
        int[] inside = [.. lit.Where(i => longitudes[i] < 5.0)];
        int[] around = [.. lit.Where(i => longitudes[i] > 5.0)];
        Assert.All(inside, i => Assert.Equal(0.25, albedos[i], Rounding.OfPlaces));
        double whole = albedos[around[0]] / rays[around[0]];
        Assert.All(around, i => Assert.Equal(whole * rays[i], albedos[i], Rounding.OfPlaces));
        Assert.True(inside.Max(i => rays[i]) > 1.05 && around.Max(i => rays[i]) > 1.05, "the site, or what is around it, has no rays");
    }

    [Theory]
    [InlineData("--renderer native --layers rays", 1, "--layers: rays needs invented ground. Give --refine with a seed")]
    [InlineData("--renderer native --refine -1", 1, "--refine")]
    [InlineData("--renderer native --refine rough", 1, "--refine is 'rough'; a whole number from 0 to 18446744073709551615")]
    [InlineData("--renderer native --refine 1 --refine-cell 0.001", 1, "--refine-cell")]
    [InlineData("--renderer native --refine 1 --refine-cell wide", 1, "--refine-cell")]
    [InlineData("--renderer native --refine-cell 1", 1, "--refine-cell is given, but no --refine.")]
    [InlineData("--renderer native --refine 1 --lod-error 2", 1, "--lod-error is for levels of detail of one model")]
    [InlineData("--refine 1", 1, "--refine is for --renderer native only.")]
    [InlineData("--renderer native --refine 1 --body mercury --ldem MOON", 1, "--body mercury can't be combined with --refine")]
    [InlineData(
        "--renderer native --refine 1 --ldem MAP", 2, "a map of a part of the Moon. Detail is invented in models of the whole Moon")]
    public void Run_WrongOptions_AreRefusedInOneLine(string options, int exitCode, string message)
    {
        string[] words = [.. options.Split(' ').Select(word => word switch { "MOON" => Moon(), "MAP" => Map(), _ => word })];
        CommandLineRun run = CommandLineRun.Of([.. View.Split(' '), .. words, "--output-dir", _folder["out"]]);

        Assert.Equal(exitCode, run.ExitCode);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.Single(run.Error.Split('\n'), line => line.Contains("error", StringComparison.Ordinal));
        Assert.False(Directory.Exists(_folder["out"]) && Directory.EnumerateFiles(_folder["out"]).Any());
    }

    /// <summary>
    /// The ground around a real map is invented at all heights, also where the camera stands over the map and looks beside it; what is left
    /// are the rings between windows.
    /// </summary>
    [RequiresTheory(Part.Ldem4, Part.PolarPieces, Part.GdalLibrary)]
    [InlineData(5_000, 60)]
    [InlineData(2_500, 20)]
    public void Run_AroundARealMap_ThereIsInventedGround(int height, int offNadir)
    {
        CommandLineRun run = Run(
            [$"--position=-84.809,125.96,terrain+{height}", "--off-nadir", $"{offNadir},20", "--time", "61060.06223", "--batch", "--width",
                "80", "--height", "60", "--fov", "60", "--renderer", "native", "--ldem", TestParts.Ldem4Label!, "--ldem",
                TestParts.PolarPiece("NPC")!, "--refine", "1", "--layers", "source", "--layers-format", "npy"],
            "site");

        Assert.True(run.ExitCode == 0, run.Error);
        byte[] file = File.ReadAllBytes(Path.Combine(_folder["out"], "site.source.npy"));
        int[] kinds = [.. Enumerable.Range(0, 80 * 60).Select(pixel => BitConverter.ToInt32(file, file.Length - 4 - (8 * pixel)))];
        Assert.InRange(kinds.Count(kind => kind == 4), 0.9 * kinds.Length, kinds.Length);
    }

    private static string[] Rest { get; } =
        ["--ignore-sun", "--batch", "--width", "40", "--height", "40", "--fov", "40", "--renderer", "native", "--exposure", "2"];

    private CommandLineRun Run(string[] options, string name) =>
        CommandLineRun.Of([.. options, "--output-dir", _folder["out"], "--output-name", name]);

    private CommandLineRun Draw(string name, params string[] options) => CommandLineRun.Of(
        [.. View.Split(' '), "--renderer", "native", "--exposure", "2", "--surface", "terrain", "--gridH", "2", "--gridV", "2",
            .. options, "--output-dir", _folder["out"], "--output-name", name]);

    private double[] Doubles(string name, string layer)
    {
        byte[] file = File.ReadAllBytes(Path.Combine(_folder["out"], $"{name}.{layer}.npy"));
        return [.. Enumerable.Range(-40_000, 40_000).Select(pixel => BitConverter.ToDouble(file, file.Length + (8 * pixel)))];
    }

    private string Moon() => SyntheticModels.Make(_folder["model"], "--res", "2");

    private string Map() => SyntheticModels.MakePolar(_folder["model"], 10000);
}
