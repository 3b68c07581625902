using System.Security.Cryptography;
using System.Text.Json;
using Msisf.Adapters.Maps;
using Msisf.Core.Ephemeris;
using Msisf.Core.Maps;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Maps;

/// <summary>Maps of <c>msis illumination</c>, as GDAL and Astropy read them.</summary>
public sealed class LightMapTests : IDisposable
{
    private const string Interval = "2026-01-01T00:00:00Z:6h:2026-01-02T12:00:00Z";

    /// <summary>degrees: a metre on the Moon is 33e-6; numbers are rounded to 16 digits.</summary>
    private const double MostOff = 1e-10;

    private static readonly string Reader = Path.Combine(
        TestParts.RepositoryRoot, "tests", "Msisf.Integration.Tests", "Maps", "light_maps.py");

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>A file says what it holds, in which unit, how high over the ground, for which times; all forms hold the same.</summary>
    [RequiresFact(Part.Ldem4, Part.Gdal, Part.GdalLibrary, Part.CFitsio, Part.Astropy)]
    public void Maps_SayWhatTheyHold()
    {
        const string Plane = "a plane tilted by 60 degrees, its normal at 40.5 degrees from north over east";
        JsonElement[] lines = Read(
            "flux_plane_max_2.5m", "--center", "-89.6,100", "--size", "4,3", "--cell", "1000", "--above-ground", "0,2.5", "--sun", "point",
            "--plane", "60,40.5");

        string[] names =
            ["description", "unit", "shown", "MAP", "HEIGHT_OVER_GROUND_M", "TIME_START", "TIME_END", "TIME_STEP_HOURS", "SUN", "nodata"];
        Assert.Equal(
            [
                $"Greatest light on {Plane}.", "W/m2", "True", "flux_plane_max_2.5m", "2.5", "2026-01-01T00:00:00Z",
                "2026-01-02T12:00:00Z", "6", "point", "nan",
            ],
            names.Select(name => lines[0].GetProperty(name).ToString()));
        Assert.Equal(
            [
                "UTC", "2026-01-01T00:00:00", "2026-01-02T12:00:00", "6.0", "point", "W/m2", "2.5", $"Greatest light on {Plane}.",
                "True",
            ],
            lines[1].EnumerateObject().Select(value => value.Value.ToString()));
    }

    /// <summary>
    /// Of each kind of map, on both sides of longitude 0 too: the files name the reference system as PROJ knows it, cells lie where
    /// spherical formulas have them by FITS's world coordinates and by GDAL, and the program, the call and all files are named.
    /// </summary>
    [RequiresTheory(Part.Ldem4, Part.Gdal, Part.GdalLibrary, Part.CFitsio, Part.Astropy)]
    [InlineData("IAU_2015:30135", "SELN-STG", 1737400.0, "--center", "-88,100", "--size", "40,30", "--cell", "5000")]
    [InlineData("IAU_2015:30130", "SELN-STG", 1737400.0, "--center", "46,300", "--size", "40,30", "--cell", "5000")]
    [InlineData("IAU_2015:30100", "SELN-CAR", 1737400.0, "--corners", "-31,359,-29,2", "--cell", "20000")]
    [InlineData("IAU_2015:30100", "SELN-CAR", 1737400.0, "--center", "40,180", "--size", "40")]
    [InlineData(null, "MELN-STG", 2439400.0, "--body", "mercury", "--ldem", "-", "--center", "85,30", "--size", "60", "--cell", "20000")]
    [InlineData(null, "MELN-CAR", 2439400.0, "--body", "mercury", "--ldem", "-", "--center", "5,30", "--size", "60", "--cell", "20000")]
    public void Maps_SayWhereTheyLie(string? crs, string type, double radius, params string[] place)
    {
        bool isMoon = crs is not null;
        if (!isMoon)
        {
            Assert.Equal(0, CommandLineRun.Of(
                ["ldem", "synthesize", "--body", "mercury", "--res", "1", "--seed", "1", "--output-dir", _folder.Path]).ExitCode);
            place[3] = Directory.GetFiles(_folder.Path, "*.LBL").Single();
        }

        JsonElement[] lines = Read("flux_tracking", place);

        JsonElement origin = lines[2];
        Assert.Equal(
            [type, type.Replace("LN", "LT", StringComparison.Ordinal)],
            origin.GetProperty("types").EnumerateArray().Select(each => each.GetString()));
        Assert.Equal(radius, origin.GetProperty("radius").GetDouble());
        Assert.InRange(origin.GetProperty("wcs").GetDouble(), 0.0, MostOff);
        Assert.InRange(origin.GetProperty("proj").GetDouble(), 0.0, MostOff);
        Assert.True(lines[0].GetProperty("is_named").GetBoolean());
        Assert.Equal(crs, lines[0].TryGetProperty("CRS", out JsonElement name) ? name.GetString() : null);
        JsonElement fits = origin.GetProperty("of_fits");
        JsonElement json = origin.GetProperty("json");
        Assert.Equal(crs, fits.GetProperty("CRS").GetString());
        Assert.Equal(crs, json.GetProperty("crs").GetString());

        string command = "illumination " + string.Join(' ', Canonical(place)) + " --time-interval " + Interval;
        foreach ((string creator, string given) in (ReadOnlySpan<(string, string)>)
            [
                (fits.GetProperty("CREATOR").GetString()!, fits.GetProperty("CMDLINE").GetString()!),
                (lines[0].GetProperty("CREATOR").GetString()!, lines[0].GetProperty("COMMAND").GetString()!),
                (json.GetProperty("creator").GetString()!, json.GetProperty("commandLine").GetString()!),
            ])
        {
            Assert.StartsWith("MSISF ", creator, StringComparison.Ordinal);
            Assert.Equal(Sorted(command + $" --ephemeris builtin --format {FormatOf(given)}"), Sorted(given));
        }

        // Each file by its name and the checksum of its content.
        string model = isMoon ? "LDEM_4.IMG" : Path.GetFileName(Directory.GetFiles(_folder.Path, "*.IMG").Single());
        string folder = isMoon ? Path.GetDirectoryName(TestParts.Ldem4Label!)! : _folder.Path;
        string modelText = $"{model} sha256:{Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(Path.Combine(folder, model))))}";
        string kernelText = $"de421.bsp sha256:{Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(
            Path.Combine(TestParts.RepositoryRoot, "kernels", "de421.bsp"))))}";
        Assert.Contains(modelText, lines[0].GetProperty("MODELS").GetString(), StringComparison.Ordinal);
        Assert.Contains(kernelText, lines[0].GetProperty("KERNELS").GetString(), StringComparison.Ordinal);
        string[] inputs = [.. origin.GetProperty("inputs").EnumerateArray().Select(each => each.GetString()!)];
        Assert.Contains($"elevation-image {modelText}", inputs);
        Assert.Contains($"kernel {kernelText}", inputs);
        Assert.Contains(kernelText[^64..], origin.GetProperty("kernel_hashes").EnumerateArray().Select(each => each.GetString()));
    }

    /// <summary>The IAU's names of all bodies and maps, and maps without one, as PROJ has them.</summary>
    [RequiresFact(Part.Gdal, Part.Astropy)]
    public void Reference_OfEachBodyAndMap_IsThatOfProj()
    {
        string[] lines = [.. CelestialBody.All.SelectMany(body => Maps(body)).Select(map => MapReference.Of(map.Map, map.Body))
            .Select(reference => $"{reference.Name}\t{reference.Wkt}")];
        Assert.Equal(CelestialBody.All.Count * 8, lines.Length);
        Assert.Equal(CelestialBody.All.Count * 7, lines.Count(line => line.StartsWith("IAU_2015:", StringComparison.Ordinal)));
        string list = _folder.Write("references.txt", string.Join('\n', lines));
        Assert.Equal(string.Empty, ChildRun.Of(TestParts.Python!, ["-B", Reader, list, "references"], _folder.Path).Succeeded().Output);

        static IEnumerable<(GroundProjection Map, CelestialBody Body)> Maps(CelestialBody body)
        {
            // Spheres of the IAU (2015): 100 times the body's number in PROJ.
            double radius = body.Name switch { "Mercury" => 2_440_530.0, "Mars" => 3_396_190.0, _ => body.MeanRadius };
            double quarter = 0.5 * Math.PI;
            yield return (new GroundProjection(MapKind.LongitudeLatitude, 0.0, 0.3, radius), body);
            yield return (new GroundProjection(MapKind.Equirectangular, 0.0, 0.0, radius), body);
            yield return (new GroundProjection(MapKind.Equirectangular, 0.0, Math.PI, radius), body);
            yield return (new GroundProjection(MapKind.PolarStereographic, quarter, 0.0, radius), body);
            yield return (new GroundProjection(MapKind.PolarStereographic, -quarter, 0.0, radius), body);
            yield return (new GroundProjection(MapKind.Orthographic, 0.0, 0.0, radius), body);
            yield return (new GroundProjection(MapKind.Orthographic, 0.0, Math.PI, radius), body);
            yield return (new GroundProjection(MapKind.Orthographic, 0.3, 1.0, radius), body);
        }
    }

    /// <summary>Words of the call as a map has them: files without their folders.</summary>
    private static IEnumerable<string> Canonical(string[] place) => place.Select(word => word.EndsWith(".LBL", StringComparison.Ordinal)
        ? Path.GetFileName(word)
        : word);

    private static string FormatOf(string command) => command.Split("--format ")[1].Split(' ')[0];

    private static string[] Sorted(string command) => [.. command.Split(" --").Order(StringComparer.Ordinal)];

    /// <summary>Makes maps in all forms and reads one of them.</summary>
    private JsonElement[] Read(string map, params string[] place)
    {
        foreach (string format in (string[])["geotiff", "fits", "npy"])
        {
            CommandLineRun run = CommandLineRun.Of(
                [
                    "illumination", .. place, "--time-interval", Interval, "--format", format, "--ephemeris", "builtin", "--output-dir",
                    _folder.Path, "--batch",
                ]);
            Assert.True(run.ExitCode == 0, run.Error);
        }

        return [.. ChildRun.Of(TestParts.Python!, ["-B", Reader, _folder.Path, map], _folder.Path).Succeeded().Output.TrimEnd().Split('\n')
            .Select(line => JsonDocument.Parse(line).RootElement)];
    }
}
