using System.Globalization;
using System.Text.Json;
using System.Xml.Linq;
using Msisf.Core.Attitude;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary><c>--dry-run</c> as a user calls it.</summary>
public sealed class DryRunTests : IDisposable
{
    /// <summary>A resolution of which no model is in input/ldem: heights are over the sphere, whatever models a desk has.</summary>
    private const string WithoutModel = "--res 7 --ephemeris builtin --dry-run";

    /// <summary>Degrees: the built-in engine agrees with CSPICE to 1e-9 degrees; the point under the camera is rounded to 1e-13.</summary>
    private const double SunTolerance = 1e-7;

    /// <summary>Degrees: 0.03 mm on the ground, of two ways to find a point by doubles.</summary>
    private const double PlaceTolerance = 1e-9;

    /// <summary>Three frames: one of the near side, one that looks away, one of the far side; the Sun is over 316 degrees east.</summary>
    private const string ThreeStates =
        "55289 0 -2000000 0 0 0 -0.7071067811865476 0.7071067811865476\n"
            + "55289 0 -2000000 0 0 0 0.7071067811865476 0.7071067811865476\n"
            + "55289.5 -2000000 0 0 0 0 1 0\n";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void DryRun_Csv_HasTheNumbersOfJson()
    {
        CommandLineRun csv = Run($"{WithoutModel} --format csv --batch-file -", ThreeStates);
        CommandLineRun json = Run($"{WithoutModel} --format json --batch-file -", ThreeStates);

        Assert.Equal((0, 0), (csv.ExitCode, json.ExitCode));
        string[][] lines = [.. csv.Output.TrimEnd().Split('\n').Select(line => line.Split(','))];
        using JsonDocument document = JsonDocument.Parse(json.Output);
        JsonElement[] objects = [.. document.RootElement.EnumerateArray()];
        Assert.Equal(3, objects.Length);
        Assert.Equal(4, lines.Length);
        Assert.All(objects.Zip(lines[1..]), pair => Assert.Equal(
            lines[0].Zip(pair.Second), pair.First.EnumerateObject().Select(property => (property.Name, TextOf(property.Value)))));
        Assert.Equal(["1", "2", "3"], lines[1..].Select(line => line[0]));
        Assert.Equal(
            ["2010-04-03T00:00:00Z", "2010-04-03T00:00:00Z", "2010-04-03T12:00:00Z"], lines[1..].Select(line => line[1]));
    }

    [Fact]
    public void DryRun_Table_IsAlignedAndHasNoNumberWhereThereIsNone()
    {
        CommandLineRun run = Run($"{WithoutModel} --batch-file -", ThreeStates);

        Assert.Equal(0, run.ExitCode);
        string[] lines = run.Output.TrimEnd().Split('\n');
        Assert.Equal(6, lines.Length);
        Assert.All(lines, line => Assert.Equal(lines[0].Length, line.Length));

        // The Sun as tests/reference/sun_in_the_sky.py has it. Straight below 262.6 km a pixel is 262600 x 2 tan(20 degrees) / 1024 =
        // 186.677 m wide; a cell of 7 px/deg has 4 331.9 m.
        Assert.Equal(
            "1 2010-04-03T00:00:00Z 0.0000 270.0000 262600.0 0.0000 270.0000 0.00 44.10 87.85 186.677 23.21 1.000 1.000",
            Words(lines[3]));
        Assert.Equal("2 2010-04-03T00:00:00Z 0.0000 270.0000 262600.0 - - 180.00 - - - - 0.000 -", Words(lines[4]));
        Assert.EndsWith(" 1.000 0.000", Words(lines[5]), StringComparison.Ordinal);
    }

    /// <summary>Whatever the roll angle, what is beside the Moon is told as such, and no form has a -0.</summary>
    [Theory]
    [InlineData("csv")]
    [InlineData("json")]
    [InlineData("table")]
    public void DryRun_EachRollBesideTheMoon_IsZeroAndNoted(string format)
    {
        string states = "time,lat,lon,height,off_nadir,roll\n"
            + string.Concat(Enumerable.Range(0, 144).Select(step => FormattableString.Invariant($"55289,-1e-9,30,1e5,120,{2.5 * step}\n")));

        CommandLineRun run = Run($"{WithoutModel} --fov 40 --width 64 --height 64 --format {format} --batch-file -", states);

        Assert.Contains("144 of 144 frames do not show the Moon.", run.Error, StringComparison.Ordinal);
        Assert.DoesNotMatch(@"-0(\.0*)?(?![\d.])", run.Output);
        if (format == "csv")
        {
            Assert.All(run.Output.TrimEnd().Split('\n')[1..], line => Assert.EndsWith(",0,", line, StringComparison.Ordinal));
        }
    }

    [Fact]
    public void DryRun_FieldOfViewInRadians_Warns() => Assert.Contains(
        "msis: warning: --fov 0.7854 is in degrees: ",
        Run($"{WithoutModel} --fov 0.7854 --batch-file -", ThreeStates).Error,
        StringComparison.Ordinal);

    [Fact]
    public void DryRun_Notes_StandOnStandardErrorOnce()
    {
        CommandLineRun run = Run($"{WithoutModel} --batch-file -", ThreeStates);

        string[] notes = [.. run.Error.TrimEnd().Split('\n')[1..]];
        Assert.Equal(
            [
                "msis: No elevation model of 7 px/deg is there: heights are over the sphere of 1737400 m. Drawing needs the model.",
                "msis: 1 of 3 frames does not show the Moon (step 2).",
                "msis: 1 of 3 frames shows no lit ground (step 3).",
                "msis: Cells of the model are 23 px wide in the image at step 1: a finer model (--res) would show more, and "
                    + "--look photo invents what it lacks.",
            ],
            notes);
    }

    [Fact]
    public void DryRun_NoFrameSeesTheMoon_IsNoError()
    {
        CommandLineRun run = Run($"{WithoutModel} --batch-file - --frames 2", ThreeStates);

        Assert.Equal(0, run.ExitCode);
        Assert.Contains("The image does not show the Moon.", run.Error, StringComparison.Ordinal);
        Assert.Equal(4, run.Output.TrimEnd().Split('\n').Length);
        Assert.StartsWith("2 ", Words(run.Output.TrimEnd().Split('\n')[3]), StringComparison.Ordinal);
    }

    [Fact]
    public void DryRun_WritesNothing()
    {
        CommandLineRun run = CommandLineRun.Of(
            [.. WithoutModel.Split(' '), "--batch-file", "-", "--output-dir", _folder["new"]], ThreeStates);

        Assert.Equal(0, run.ExitCode);
        Assert.Empty(Directory.EnumerateFileSystemEntries(_folder.Path));
    }

    /// <summary>Azimuths and elevations of CSPICE N0067 (azlcpo_c): tests/reference/sun_in_the_sky.py.</summary>
    [Theory]
    [InlineData(55289.0, 26.1, 3.6, 249.830854161373, 38.008609644000)]
    [InlineData(55289.0, 60.0, 180.0, 47.622502359127, -19.602155140506)]
    [InlineData(65000.270833333336, -43.3, 348.8, 21.730516264430, 42.963129326484)]
    [InlineData(65000.270833333336, -89.5, 222.0, 142.516732752399, -1.962907637000)]
    public void DryRun_TheSunBelowTheCamera_IsWhereCSpiceHasIt(
        double mjd, double latitude, double longitude, double azimuth, double elevation)
    {
        Vector3D position = 2e6
            * new SelenographicPoint(double.DegreesToRadians(latitude), double.DegreesToRadians(longitude)).ToDirectionBodyFixed();
        UnitQuaternion q = NadirPointing.MoonFromCamera(position);
        string state = string.Create(
            CultureInfo.InvariantCulture,
            $"{mjd:R} {position.X:R} {position.Y:R} {position.Z:R} {q.X:R} {q.Y:R} {q.Z:R} {q.W:R}");

        CommandLineRun run = Run($"{WithoutModel} --format json --batch-file -", state);

        Assert.True(run.ExitCode == 0, run.Error);
        using JsonDocument document = JsonDocument.Parse(run.Output);
        JsonElement row = document.RootElement[0];
        double Number(string name) => row.GetProperty(name).GetDouble();
        Assert.Equal(latitude, Number("boresight_latitude_deg"), SunTolerance);
        Assert.Equal(longitude, Number("boresight_longitude_deg"), SunTolerance);
        Assert.Equal(azimuth, Number("sun_azimuth_deg"), SunTolerance);
        Assert.Equal(elevation, Number("sun_elevation_deg"), SunTolerance);
    }

    /// <summary>
    /// The line of sight ends at the terrain, where the drawn image has its middle pixel, and not kilometres away on the sphere.
    /// </summary>
    [RequiresFact(Part.Ldem4)]
    public void DryRun_ObliqueView_LooksAtTheTerrainThatIsDrawn()
    {
        string[] view =
        [
            .. "--ephemeris builtin --width 63 --height 63 --position=-43,-15,30000 --off-nadir 50,80 --time 2010-04-24T00:00:00Z --ldem"
                .Split(' '),
            TestParts.Ldem4Label!,
        ];

        CommandLineRun told = CommandLineRun.Of([.. view, "--dry-run", "--format", "json"]);
        CommandLineRun drawn = CommandLineRun.Of(
            [.. view, "--renderer", "native", "--surface", "terrain", "--grid", "32", "--lod", "off", "--output-dir", _folder["drawn"]]);

        Assert.True((told.ExitCode, drawn.ExitCode) == (0, 0), told.Error + drawn.Error);
        using JsonDocument document = JsonDocument.Parse(told.Output);
        XElement pixel = XDocument.Load(Directory.GetFiles(_folder["drawn"], "*.xml").Single()).Descendants("Pixel")
            .Single(found => (string?)found.Attribute("h") == "32" && (string?)found.Attribute("v") == "32");
        foreach ((string column, string attribute) in (ReadOnlySpan<(string, string)>)
            [("boresight_latitude_deg", "lat"), ("boresight_longitude_deg", "lon")])
        {
            double degrees = (double)pixel.Element("SelenographicCoordinates")!.Attribute(attribute)!;
            Assert.Equal(degrees, document.RootElement[0].GetProperty(column).GetDouble(), PlaceTolerance);
        }

        Assert.True(Math.Abs((double)pixel.Element("Height")!) > 100.0, "the ground is too near to the sphere to tell them apart");
    }

    [Fact]
    public void DryRun_IgnoreSun_HasNoSunAndLightsAll()
    {
        CommandLineRun run = Run($"{WithoutModel} --ignore-sun --frames 3 --batch-file -", ThreeStates);

        Assert.EndsWith(" 0.00 - - 186.677 23.21 1.000 1.000", Words(run.Output.TrimEnd().Split('\n')[3]), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--format csv", 1, "--format is for --dry-run only")]
    [InlineData("--dry-run --list-patterns", 1, "--dry-run and --list-patterns exclude each other")]
    [InlineData("--dry-run --format xml", 1, "--format is 'xml'; one of table, csv, json is needed")]
    [InlineData("--dry-run --ephemeris builtin --res 7 --fixed-state {55289,1.7E6,0,0,0,0,0,1}", 2, "the camera is inside the Moon")]
    [InlineData("--dry-run --ldem missing.lbl --ephemeris builtin", 2, "missing.lbl")]
    [InlineData("--dry-run --frames 3 --ephemeris builtin", 1, "step 3 is wanted, but the run has 1 only")]
    public void DryRun_WrongOptions_AreRefused(string words, int exitCode, string message)
    {
        string[] fixedState = words.Contains("--fixed-state", StringComparison.Ordinal) ? [] : ["--fixed-state", "{55289,2E6,0,0,0,0,0,1}"];
        RefusedRun.Check(_folder, [.. fixedState, .. words.Split(' ')], exitCode, message);
    }

    private static CommandLineRun Run(string words, string standardInput) => CommandLineRun.Of(words.Split(' '), standardInput);

    private static string Words(string line) => string.Join(' ', line.Split(' ', StringSplitOptions.RemoveEmptyEntries));

    private static string TextOf(JsonElement value) => value.ValueKind switch
    {
        JsonValueKind.Null => string.Empty,
        JsonValueKind.Number => value.GetDouble().ToString("R", CultureInfo.InvariantCulture),
        _ => value.GetString()!,
    };
}
