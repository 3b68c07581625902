using System.Globalization;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Twins;

/// <summary><c>msis twin</c> on cubes that numpy makes from the camera models of real images; twins.py has ISIS's formulas.</summary>
public sealed partial class TwinTests(TwinCubes cubes) : IClassFixture<TwinCubes>, IDisposable
{
    /// <summary>px: the largest is that of NAC's, with 0.5 m a pixel and positions of the layer in float.</summary>
    private const double Tolerance = 0.001;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.Ldem4, Part.Numpy, Part.LroNac)]
    [InlineData("clementine", 288 * 384)]
    [InlineData("kaguya", 6 * 4096)]
    [InlineData("nac", 6 * 5064)]
    [InlineData("m3", 5 * 608)]
    public void Tables_OfARealImage_LookWhereIsissFormulasSay(string name, int pixels)
    {
        Twin(name);
        string command = Json($"{name}/{name}.twin.layers.json").GetProperty("commandLine").GetString()!;
        string states = _folder[$"{name}/{name}.twin.states.tab"];
        string[] exposures = File.Exists(states)
            ? ["--trajectory", states, "--lines", Word(command, "--lines"), "--scan-period", Word(command, "--scan-period")]
            : ["--fixed-state", FixedState().Match(command).Value];
        Succeed(
        [
            "--camera", _folder[$"{name}/{name}.twin.camera.yaml"], .. exposures, "--renderer", "native", "--layers", "position",
            "--layers-format", "npy",
            "--output-dir", _folder["again"], "--output-name", "p", "--batch",
        ]);

        string[] found = TwinCubes.Numpy("check", TwinCubes.Models, name, _folder["again/p.position.npy"], "-").Split(' ');

        Assert.StartsWith($"{name}.twin.camera.yaml", Word(command, "--camera"), StringComparison.Ordinal);
        Assert.Equal(pixels, int.Parse(found[1], CultureInfo.InvariantCulture));
        Assert.True(double.Parse(found[0], CultureInfo.InvariantCulture) < Tolerance, found[0]);
    }

    /// <summary>The real image is the twin, moved by 3 and -2 px, times 5000, with noise and a gap.</summary>
    [RequiresFact(Part.Ldem4, Part.Numpy, Part.LroNac)]
    public void Comparison_OfAMovedTwin_FindsWhatNumpyFinds()
    {
        Twin("clementine");
        string real = _folder["clementine.cub"];
        File.Copy(cubes["clementine"], real);
        TwinCubes.Numpy("shift", _folder["clementine/clementine.twin.npy"], real, "5000", "3", "-2");
        Twin(real, "clementine", []);
        string[] numpy = TwinCubes.Numpy("agree", _folder["clementine/clementine.twin.npy"], real).Split(' ');
        JsonElement found = Json("clementine/clementine.twin.json").GetProperty("comparison");

        Assert.Equal(int.Parse(numpy[0], CultureInfo.InvariantCulture), found.GetProperty("pixels").GetInt32());
        string[] names = ["correlation", "factor", "relativeRms"];
        Assert.All(names.Zip(numpy[1..]), pair => Assert.Equal(
            double.Parse(pair.Second, CultureInfo.InvariantCulture), found.GetProperty(pair.First).GetDouble(), 1e-6 * 5000));
        Assert.Equal(
            double.Parse(numpy[1], CultureInfo.InvariantCulture), found.GetProperty("correlation").GetDouble(), 1e-6);
        Assert.Equal(3.0, found.GetProperty("shift").GetProperty("right").GetDouble(), 0.1);
        Assert.Equal(-2.0, found.GetProperty("shift").GetProperty("down").GetDouble(), 0.1);
        JsonElement[] blocks = [.. found.GetProperty("blocks").EnumerateArray()];
        Assert.Equal(30, blocks.Length);
        Assert.Contains(blocks, block => block.GetProperty("shift").ValueKind == JsonValueKind.Object
            && Math.Abs(block.GetProperty("shift").GetProperty("right").GetDouble() - 3.0) < 0.2);
        string page = File.ReadAllText(_folder["clementine/clementine.twin.html"]);
        Assert.Equal(4, page.Split("<img ").Length - 1);
        Assert.Contains("Clementine UVVIS", page, StringComparison.Ordinal);
    }

    /// <summary>The sky behind a twin has its list; what is compared is the ground alone.</summary>
    [RequiresFact(Part.Ldem4, Part.Numpy, Part.LroNac)]
    public void Sky_IsBehindTheTwin()
    {
        Twin("clementine");
        Twin(cubes["clementine"], "sky", ["--stars", "--earth"]);

        Assert.StartsWith("id,h,v,", File.ReadAllText(_folder["sky/clementine.twin.stars.csv"]), StringComparison.Ordinal);
        Assert.Equal(
            File.ReadAllBytes(_folder["clementine/clementine.twin.radiance-factor.npy"]),
            File.ReadAllBytes(_folder["sky/clementine.twin.radiance-factor.npy"]));
    }

    /// <summary>Texts of equal length, so that the tables stay in their places.</summary>
    [RequiresTheory(Part.Ldem4, Part.Numpy, Part.LroNac)]
    [InlineData("TargetName = Moon", "TargetName = Mars", 2, "the image is of Mars, and the Moon is drawn. Give --body mars")]
    [InlineData("InstrumentId = UVVIS", "InstrumentId = HIRES", 2, "HIRES' is not known. Known are LROC NAC; LROC WAC")]
    [InlineData("Name = BodyRotation", "Name = BodyNotation", 2, "it has no table BodyRotation. Run ISIS's spiceinit")]
    [InlineData("StartTime = 1994", "StartTime = 1995", 2, "table BodyRotation reaches from")]
    [InlineData("StartTime = 1994", "StartTime = soon", 2, "STARTTIME is 'soon")]
    [InlineData("Samples = 384", "Samples = 400", 2, "400 samples are not of camera clementine-uvvis")]
    [InlineData("CacheType = Linear", "CacheType = Cosine", 2, "has the CacheType Cosine")]
    [InlineData("Name = J2000Q3", "Name = J2000Q9", 2, "has the columns J2000Q0, J2000Q1, J2000Q2, J2000Q9")]
    [InlineData("Lines = 288", "Lines = 999", 2, "lines are not of camera")]
    public void WrongCube_IsOneLine_AndLeavesNothing(string text, string wrong, int exitCode, string expected)
    {
        byte[] cube = File.ReadAllBytes(cubes["clementine"]);
        int at = Encoding.Latin1.GetString(cube).IndexOf(text, StringComparison.Ordinal);
        Encoding.ASCII.GetBytes(wrong).CopyTo(cube, at);
        File.WriteAllBytes(_folder["wrong.cub"], cube);

        Refused(_folder["wrong.cub"], exitCode, expected);
    }

    /// <summary>Another focal length in the cube's own keywords than the preset's: the twin has it.</summary>
    [RequiresFact(Part.Ldem4, Part.Numpy, Part.LroNac)]
    public void Keywords_OfTheCube_AreTheTwinsOptics()
    {
        byte[] cube = File.ReadAllBytes(cubes["nac"]);
        int at = Encoding.Latin1.GetString(cube).IndexOf("FOCAL_LENGTH = 699.62", StringComparison.Ordinal);
        "FOCAL_LENGTH = 690.25"u8.CopyTo(cube.AsSpan(at));
        File.WriteAllBytes(_folder["own.cub"], cube);
        Twin(_folder["own.cub"], "own", []);
        string command = Json("own/own.twin.layers.json").GetProperty("commandLine").GetString()!;

        Assert.StartsWith("own.twin.camera.yaml#", Word(command, "--camera"), StringComparison.Ordinal);
        Adapters.Camera.CameraFile camera = Adapters.Camera.CameraFileReader.Read(_folder["own/own.twin.camera.yaml"]);
        Assert.Equal(0.69025, camera.FocalLength!.Value, 1e-12);
        Assert.Equal(690.25 / 0.007, camera.Model.FocalX, 1e-6);
    }

    /// <summary>START_TIME of M3's labels is not the time of line 1, which their table of times has.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Pds3LabelOfM3_IsRefused() => Refused(
        _folder.Write(
            "m3.lbl", "PDS_VERSION_ID = PDS3\n^IMAGE = \"m3.img\"\nINSTRUMENT_ID = M3\nTARGET_NAME = MOON\n"
                + "START_TIME = 2009-06-30T08:34:07\nOBJECT = IMAGE\n LINES = 5\n LINE_SAMPLES = 608\n SAMPLE_TYPE = PC_REAL\n"
                + " SAMPLE_BITS = 32\nEND_OBJECT = IMAGE\nEND\n"),
        2, "Chandrayaan-1 M3: a PDS3 label does not say when its lines were taken", Kernels);

    /// <summary>The pixels end at byte 507,904, the tables 200 bytes later.</summary>
    [RequiresTheory(Part.Ldem4, Part.Numpy, Part.LroNac)]
    [InlineData(300_000, "the file is cut off")]
    [InlineData(507_950, "table BodyRotation needs")]
    public void CutOffCube_IsOneLine_AndLeavesNothing(int bytes, string expected)
    {
        File.WriteAllBytes(_folder["cut.cub"], File.ReadAllBytes(cubes["clementine"])[..bytes]);

        Refused(_folder["cut.cub"], 2, expected);
    }

    /// <summary>A label alone is drawn by kernels; times that they do not cover are an error.</summary>
    [RequiresFact(Part.Ldem4, Part.LroNac)]
    public void Kernels_OfAPds3Label_DrawTheImageOrSayWhatTheyCover()
    {
        string label = Path.Combine(LroNac.Folder, "M103595705LE_pds3.lbl");
        Twin(label, "nac", [.. Kernels, "--image-lines", "101-104"]);
        JsonElement found = Json("nac/M103595705LE_pds3.twin.json");

        // The first line's start by USGS's camera model, lrolroc_isd.json, and 100.5 lines more.
        Assert.Equal(302228504.36824864 + (100.5 * 0.0010334295999999998), found.GetProperty("firstExposureTdb").GetDouble(), 1e-7);
        Assert.Equal(4, found.GetProperty("lines").GetInt32());
        Assert.Equal(JsonValueKind.Null, found.GetProperty("comparison").ValueKind);
        File.WriteAllText(_folder["late.lbl"], File.ReadAllText(label).Replace("1/270649237", "1/270749237", StringComparison.Ordinal));
        Refused(_folder["late.lbl"], 2, "is outside what the kernels have of LRO (-85)", Kernels);
        Refused(label, 1, "Name its kernels: --spk, --ck and --kernels.");
    }

    /// <summary>Where nothing can be written, nothing is left.</summary>
    [RequiresFact(Part.Ldem4, Part.Numpy, Part.LroNac)]
    public void OutputThatCanNotBeWritten_IsOneLine()
    {
        File.WriteAllText(_folder["file"], string.Empty);
        CommandLineRun run = CommandLineRun.Of(["twin", cubes["m3"], "--output-dir", _folder["file/out"], "--batch"]);

        Assert.Equal(3, run.ExitCode);
        Assert.Contains("the folder can't be made", run.Error, StringComparison.Ordinal);
    }

    private static string[] Kernels =>
    [
        "--spk", LroNac.Spk, .. LroNac.Cks.SelectMany(ck => (string[])["--ck", ck]),
        .. LroNac.TextKernels.SelectMany(kernel => (string[])["--kernels", kernel]),
    ];

    private static string Word(string command, string option) => command.Split(' ').SkipWhile(word => word != option).ElementAt(1);

    private static void Succeed(string[] arguments)
    {
        CommandLineRun run = CommandLineRun.Of(arguments);
        Assert.True(run.ExitCode == 0, $"{string.Join(' ', arguments)}: {run.Error}");
    }

    private void Refused(string label, int exitCode, string expected, params string[] more)
    {
        CommandLineRun run = CommandLineRun.Of(["twin", label, .. more, "--output-dir", _folder["refused"], "--batch"]);

        Assert.True(exitCode == run.ExitCode, run.Error);
        Assert.Single(run.Error.Split('\n'), line => line.Contains("error: ", StringComparison.Ordinal));
        Assert.Contains(expected, run.Error, StringComparison.Ordinal);
        Assert.DoesNotContain("   at ", run.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(_folder["refused"]));
    }

    private void Twin(string name) => Twin(cubes[name], name, []);

    private void Twin(string label, string folder, string[] more) => Succeed(
        ["twin", label, "--reflectance", "lambert", "--albedo-map", "none", "--output-dir", _folder[folder], "--batch", .. more]);

    private JsonElement Json(string name) => JsonDocument.Parse(File.ReadAllText(_folder[name])).RootElement;

    [GeneratedRegex(@"\{[^}]*\}")]
    private static partial Regex FixedState();
}
