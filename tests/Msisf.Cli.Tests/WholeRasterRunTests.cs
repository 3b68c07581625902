using System.Text.RegularExpressions;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>A raster of the whole Moon is used as the PDS3 model of the same heights is, in each command that takes one.</summary>
public sealed partial class WholeRasterRunTests : IDisposable
{
    /// <summary>Writes LDEM_4 as GeoTIFF. Arguments: image, path, projection, western border in degrees.</summary>
    private const string Script = """
        import sys
        import numpy as np
        from osgeo import gdal, osr
        image, path, projection, west = sys.argv[1:5]
        a = np.roll(np.fromfile(image, '<i2').reshape(720, 1440), -4 * int(west), axis=1)
        data = gdal.GetDriverByName('GTiff').Create(path, 1440, 720, 1, gdal.GDT_Int16, ['COMPRESS=DEFLATE', 'TILED=YES'])
        system = osr.SpatialReference()
        system.ImportFromProj4(projection + ' +R=1737400')
        unit = 1.0 if 'longlat' in projection else 1737400 * np.pi / 180
        middle = float(projection.split('lon_0=')[1]) if 'lon_0' in projection else 0.0
        data.SetProjection(system.ExportToWkt())
        data.SetGeoTransform([(int(west) - middle) * unit, unit / 4, 0, 90 * unit, 0, -unit / 4])
        data.GetRasterBand(1).SetScale(0.5)
        data.GetRasterBand(1).WriteArray(a)
        """;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.Ldem4, Part.Gdal, Part.GdalLibrary)]
    [InlineData("+proj=longlat", 0)]
    [InlineData("+proj=longlat", -180)]
    [InlineData("+proj=eqc +lon_0=0", -180)]
    [InlineData("+proj=eqc +lon_0=180", 0)]
    [InlineData("+proj=eqc +lon_0=0", 77)]
    public void Run_WholeRaster_DrawsTheBytesOfTheModel(string projection, int west)
    {
        string raster = Write(projection, west);
        foreach (string lod in (string[])["off", "auto"])
        {
            Draw(TestParts.Ldem4Label!, $"model-{lod}", lod);
            Draw(raster, $"raster-{lod}", lod);
            foreach (string file in (string[])[".png", ".height.npy", ".position.npy"])
            {
                Assert.Equal(
                    File.ReadAllBytes(Path.Combine(_folder["out"], $"model-{lod}{file}")),
                    File.ReadAllBytes(Path.Combine(_folder["out"], $"raster-{lod}{file}")));
            }
        }
    }

    [RequiresFact(Part.Ldem4, Part.Gdal, Part.GdalLibrary)]
    public void Synthesize_WholeRasterAsBase_HasTheBytesOfTheModel()
    {
        string raster = Write("+proj=longlat", -180);
        foreach ((string folder, string model) in new[] { ("a", TestParts.Ldem4Label!), ("b", raster) })
        {
            CommandLineRun run = CommandLineRun.Of(
            [
                "ldem", "synthesize", "--projection", "polar-south", "--map-scale", "2000", "--latitude", "85", "--base", model,
                "--seed", "1", "--output-dir", _folder[folder],
            ]);
            Assert.True(run.ExitCode == 0, run.Error);
        }

        string image = Directory.EnumerateFiles(_folder["a"], "*.IMG").Single();
        Assert.Equal(File.ReadAllBytes(image), File.ReadAllBytes(Path.Combine(_folder["b"], Path.GetFileName(image))));
    }

    [RequiresFact(Part.Ldem4, Part.Gdal, Part.GdalLibrary)]
    public void Pyramid_WholeRaster_SaysThatItNeedsNone()
    {
        CommandLineRun run = CommandLineRun.Of(["ldem", "pyramid", Write("+proj=longlat", -180)]);
        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Contains("is so small that each run looks at all its pixels", run.Error, StringComparison.Ordinal);
    }

    /// <summary>Heights without a unit that fit the model around them much better in another one are refused; the advice works.</summary>
    [RequiresTheory(Part.Ldem4, Part.Gdal, Part.GdalLibrary)]
    [InlineData("0.5", "steps of half a metre")]
    [InlineData("0.3048", "feet")]
    public void Run_SiteInAnotherUnit_IsRefusedWithAdviceThatWorks(string unit, string name)
    {
        string site = _folder["site.tif"];
        ChildRun.Of(
            TestParts.Python!,
            [
                "-c",
                """
                import sys
                import numpy as np
                from osgeo import gdal, osr
                a = np.fromfile(sys.argv[1], '<i2').reshape(720, 1440)[280:320, 400:460] * 0.5 / float(sys.argv[3])
                data = gdal.GetDriverByName('GTiff').Create(sys.argv[2], 60, 40, 1, gdal.GDT_Float32)
                system = osr.SpatialReference()
                system.ImportFromProj4('+proj=longlat +R=1737400')
                data.SetProjection(system.ExportToWkt())
                data.SetGeoTransform([100, 0.25, 0, 20, 0, -0.25])
                data.GetRasterBand(1).WriteArray(a)
                """,
                Path.ChangeExtension(TestParts.Ldem4Label!, ".IMG"), site, unit,
            ],
            _folder.Path).Succeeded();
        CommandLineRun refused = Over(site);
        Assert.Equal(2, refused.ExitCode);
        Assert.Contains($"look like {name}", refused.Error, StringComparison.Ordinal);
        string advice = Advice().Match(refused.Error).Groups[1].Value;
        Assert.Equal($"scale={unit}", advice);
        CommandLineRun drawn = Over($"{site},{advice}");
        Assert.True(drawn.ExitCode == 0, drawn.Error);
    }

    private CommandLineRun Over(string site) => CommandLineRun.Of(
    [
        "--renderer", "native", "--ldem", TestParts.Ldem4Label!, "--ldem", site, "--position=15,107,300000", "--time",
        "2010-04-06T20:24:00Z", "--ignore-sun", "--batch", "--width", "16", "--height", "16", "--output-dir", _folder["out"],
        "--output-name", "site", "--albedo-map", "none", "--overwrite",
    ]);

    private void Draw(string model, string name, string lod)
    {
        CommandLineRun run = CommandLineRun.Of(
        [
            "--renderer", "native", "--ldem", model, "--position=20,355,1500000", "--time", "2010-04-06T20:24:00Z", "--batch",
            "--width", "48", "--height", "48", "--fov", "60", "--lod", lod, "--layers", "height,position",
            "--layers-format", "npy", "--output-dir", _folder["out"], "--output-name", name, "--albedo-map", "none",
        ]);
        Assert.True(run.ExitCode == 0, run.Error);
    }

    private string Write(string projection, int west)
    {
        string path = _folder["LDEM_4_whole.tif"];
        ChildRun.Of(
            TestParts.Python!,
            ["-c", Script, Path.ChangeExtension(TestParts.Ldem4Label!, ".IMG"), path, projection, $"{west}"], _folder.Path).Succeeded();
        return path;
    }

    [GeneratedRegex("add ,(scale=[0-9.]+) to its name")]
    private static partial Regex Advice();
}
