using System.Text.Json;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Maps;

/// <summary>Maps of <c>msis illumination</c>, as GDAL and Astropy read them.</summary>
public sealed class LightMapTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>A file says what it holds, in which unit, how high over the ground, for which times; both forms hold the same.</summary>
    [RequiresFact(Part.Ldem4, Part.Gdal, Part.GdalLibrary, Part.CFitsio, Part.Astropy)]
    public void Maps_SayWhatTheyHold()
    {
        const string Plane = "a plane tilted by 60 degrees, its normal at 40.5 degrees from north over east";
        Run("geotiff");
        Run("fits");
        string[] lines = ChildRun.Of(
            TestParts.Python!,
            [
                "-B", Path.Combine(TestParts.RepositoryRoot, "tests", "Msisf.Integration.Tests", "Maps", "light_maps.py"),
                _folder["flux_plane_max_2.5m.tif"], _folder["illumination.fits"], "FLUX_PLANE_MAX_2.5M",
            ],
            _folder.Path).Succeeded().Output.TrimEnd().Split('\n');

        Dictionary<string, JsonElement> tiff = JsonSerializer.Deserialize<Dictionary<string, JsonElement>>(lines[0])!;
        string[] names =
            ["description", "unit", "shown", "MAP", "HEIGHT_OVER_GROUND_M", "TIME_START", "TIME_END", "TIME_STEP_HOURS", "SUN"];
        Assert.Equal(
            [
                $"Greatest light on {Plane}.", "W/m2", "True", "flux_plane_max_2.5m", "2.5", "2026-01-01T00:00:00Z",
                "2026-01-02T12:00:00Z", "6", "point",
            ],
            names.Select(name => tiff[name].ToString()));
        Dictionary<string, JsonElement> fits = JsonSerializer.Deserialize<Dictionary<string, JsonElement>>(lines[1])!;
        Assert.Equal(
            [
                "UTC", "2026-01-01T00:00:00", "2026-01-02T12:00:00", "6.0", "point", "W/m2", "2.5", $"Greatest light on {Plane}.",
                "True",
            ],
            fits.Values.Select(value => value.ToString()));
    }

    private void Run(string format)
    {
        CommandLineRun run = CommandLineRun.Of(
            [
                "illumination", "--center", "-89.6,100", "--size", "4,3", "--cell", "1000", "--above-ground", "0,2.5", "--sun", "point",
                "--plane", "60,40.5", "--time-interval", "2026-01-01T00:00:00Z:6h:2026-01-02T12:00:00Z", "--format", format,
                "--ephemeris", "builtin", "--output-dir", _folder.Path, "--batch",
            ]);
        Assert.True(run.ExitCode == 0, run.Error);
    }
}
