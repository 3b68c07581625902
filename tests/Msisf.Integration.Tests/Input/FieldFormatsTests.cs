using System.Globalization;
using System.Text.Json;
using Msisf.Adapters.Catalogues;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Input;

/// <summary>Other people's files as they were reported from the field, from the command line; each folder says what is right.</summary>
public sealed class FieldFormatsTests : IDisposable
{
    private static readonly string[] View =
        ["--position", "10,20,300000", "--time", "2010-04-06T20:24:00Z", "--renderer", "native", "--batch", "--reflectance", "lambert"];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>Folder 16: six files of one camera give one image.</summary>
    [RequiresFact(Part.Field, Part.Ldem4)]
    public void Cameras_OfOtherPrograms_DrawTheSameImage()
    {
        string[] files =
        [
            "same_camera_as_msis_has_it.yaml", "opencv.yml", "ros.yaml", "kalibr.yaml", "cameras.txt", "written_by_msis.opencv.yaml",
        ];
        byte[][] images = [.. files.Select((file, index) =>
        {
            Succeed([.. View, "--camera", Field("16", file), "--output-dir", _folder.Path, "--output-name", $"c{index}"]);
            return File.ReadAllBytes(_folder[$"c{index}.png"]);
        })];

        Assert.All(images, image => Assert.Equal(images[0], image));
    }

    /// <summary>Folder 17: 270 s after the epoch the spacecraft is on its circle of 2,100 km, by either option.</summary>
    [RequiresTheory(Part.Field, Part.Ldem4)]
    [InlineData("--oem")]
    [InlineData("--trajectory")]
    public void Stk_IsRead(string option)
    {
        Succeed(
        [
            "states", option, Field("17", "orbit.e"), "--time", "2010-04-06T20:04:30Z", "--format", "oem", "--to", _folder.Path,
            "--renderer", "native",
        ]);
        double[] found = [.. Assert.Single(StatesOf(_folder["states.oem"]))];

        // km: a circle of 2100 km at 1.527961605102 km/s; degree 5 between nodes of 60 s leaves less than a metre.
        double angle = 270.0 * 1.527961605102 / 2100.0;
        Assert.Equal(2100.0 * Math.Cos(angle), found[0], 1e-3);
        Assert.Equal(2100.0 * Math.Sin(angle), found[1], 1e-3);
        Assert.Equal(0.0, found[2], 1e-3);
    }

    [RequiresFact(Part.Field)]
    public void Stk_AsBatchFile_IsNamedWithTheOption()
    {
        CommandLineRun run = CommandLineRun.Of(["--batch-file", Field("17", "orbit.e"), "--dry-run"]);

        Assert.Equal(2, run.ExitCode);
        Assert.Contains(
            "this is a trajectory without attitudes (OEM, STK or Horizons). Give it with --oem.", run.Error, StringComparison.Ordinal);
    }

    /// <summary>Folder 30: its expected.txt has the positions in J2000, km.</summary>
    [RequiresFact(Part.Field, Part.Ldem4)]
    public void Horizons_IsRead()
    {
        Succeed(
        [
            "states", "--oem", Field("30", "horizons_vectors.txt"), "--every", "60", "--format", "oem", "--to", _folder.Path, "--renderer",
            "native",
        ]);
        double[][] expected =
            [.. File.ReadLines(Field("30", "expected.txt")).Select(line => line.Split(' ')[4..7].Select(Number).ToArray())];
        double[][] found = [.. StatesOf(_folder["states.oem"])];

        Assert.Equal(3, found.Length);
        foreach ((double[] one, double[] other) in expected.Zip(found))
        {
            // km: times of an MJD have 0.6 microseconds, in which it flies 1 mm.
            Assert.All(one.Zip(other), pair => Assert.Equal(pair.First, pair.Second, 2e-6));
        }
    }

    /// <summary>Folders 15 and 27: five lists of the same craters, and a name in ISO 8859-1.</summary>
    [RequiresFact(Part.Field)]
    public void CraterLists_AreRead()
    {
        foreach (string file in (string[])["works.csv", "tab.txt", "semicolon.csv", "no_blank.csv", "comment.csv"])
        {
            Assert.Equal(
                [("1", 10.0, 20.0, 60_000.0), ("2", 12.0, 23.0, 40_000.0)],
                CraterCatalogueReader.ReadAll(Field("15", file), 1_737_400.0)
                    .Select(crater => (crater.Identity, crater.LatitudeDegrees, crater.LongitudeDegrees, crater.Diameter)));
        }

        Assert.Equal("B\u00e9la", Assert.Single(CraterCatalogueReader.ReadAll(Field("27", "latin1.csv"), 1_737_400.0)).Name);
    }

    /// <summary>Folder 21: two bands, "BAND SEQUENTIAL"; the other label of the folder has the standard's word.</summary>
    [RequiresFact(Part.Field)]
    public void Pds3_BandSequentialWithABlank_IsTheStandards()
    {
        Adapters.RealImages.PixelLayout[] layouts =
            [.. new[] { "TC1X.lbl", "ok.lbl" }.Select(file => Adapters.RealImages.ImageLabelReader.Read(Field("21", file)).Pixels)];

        Assert.Equal(layouts[1].Strides, layouts[0].Strides);
        Assert.Equal(2, layouts[0].Size.Bands);
    }

    /// <summary>Folder 28: figures that have no value are null, and a note says so.</summary>
    [RequiresTheory(Part.Field, Part.Ldem4)]
    [InlineData("zero", "the image, or its twin, is the same everywhere", true)]
    [InlineData("const", "the image, or its twin, is the same everywhere", false)]
    public void Twin_OfAnImageWithoutContrast_HasNulls(string name, string note, bool isZero)
    {
        CommandLineRun run = CommandLineRun.Of(
        [
            "twin", Field("28", $"{name}.lbl"), "--spk", Field("28", "orbit.bsp"), "--ck", Field("28", "attitude.bc"), "--kernels",
            Field("28", "clock.tsc"), "--kernels", Field("28", "frames.tf"), "--output-dir", _folder.Path, "--batch",
            "--image-lines", "1-4",
        ]);

        Assert.True(run.ExitCode == 0, run.Error);
        JsonElement found = JsonDocument.Parse(File.ReadAllText(_folder[$"{name}.twin.json"])).RootElement.GetProperty("comparison");
        Assert.Equal(JsonValueKind.Null, found.GetProperty("correlation").ValueKind);
        Assert.Equal(isZero ? JsonValueKind.Null : JsonValueKind.Number, found.GetProperty("relativeRms").ValueKind);
        Assert.Contains($"{note}: figures that have no value are null.", run.Error, StringComparison.Ordinal);
    }

    /// <summary>What the message about vector files advises, run on the file that caused it.</summary>
    [RequiresFact(Part.Gdal)]
    public void VectorFiles_AdviceOfTheirRefusal_Works()
    {
        string file = _folder.Write(
            "places.geojson", "{\"type\": \"FeatureCollection\", \"features\": [{\"type\": \"Feature\", \"properties\": {\"name\": \"a\"}, "
                + "\"geometry\": {\"type\": \"Point\", \"coordinates\": [23.5, -10.25]}}]}");
        string message = Assert.Throws<BadInputException>(() => LandmarkReader.Read(file, 1_737_400.0)).Message;
        string[] command =
        [
            .. message.Split("Save it as CSV: ")[1].Split(". Then give ")[0].Split(' ').Select(word => word == "FILE" ? file : word),
        ];
        ChildRun.Of(TestParts.Program(command[0])!, command[1..], _folder.Path).Succeeded();

        Core.Navigation.Landmark place = Assert.Single(LandmarkReader.Read(
            _folder["list.csv"], 1_737_400.0, given: ListColumns.Parse(message.Split("--columns ")[1].TrimEnd('.'))));

        (double x, double y, double z) = (place.Direction.X, place.Direction.Y, place.Direction.Z);
        Assert.Equal(-10.25, double.RadiansToDegrees(Math.Atan2(z, double.Hypot(x, y))), 1e-9);
        Assert.Equal(23.5, double.RadiansToDegrees(Math.Atan2(y, x)), 1e-9);
    }

    /// <summary>km: the positions of an OEM.</summary>
    private static IEnumerable<double[]> StatesOf(string path) => File.ReadLines(path)
        .Where(line => line.StartsWith("20", StringComparison.Ordinal))
        .Select(line => line.Split(' ')[1..4].Select(Number).ToArray());

    private static string Field(string folder, string file) => Path.Combine(TestParts.Field, folder, file);

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    private static void Succeed(string[] arguments)
    {
        CommandLineRun run = CommandLineRun.Of(arguments);
        Assert.True(run.ExitCode == 0, run.Error);
    }
}
