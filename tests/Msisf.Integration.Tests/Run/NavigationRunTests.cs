using System.Globalization;
using System.Text.Json;
using System.Xml.Linq;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>Runs with craters and landmarks: what stands in the meta file, the CSV, the JSON and the layer.</summary>
public sealed class NavigationRunTests : IDisposable
{
    private const int Width = 120;
    private const int Height = 90;

    /// <summary>m: thousands of roundings of the coordinates.</summary>
    private const double OneGround = 1e-6;

    /// <summary>Tycho, Clavius, Maginus, Longomontanus, a crater behind the limb and a small one.</summary>
    private const string Catalogue =
        "id,name,lat,lon,diam_km,lat_sd,lon_sd,diam_km_sd\n"
        + "T,Tycho,-43.3,-11.2,85,0.01,0.01,0.5\nC,\"Clavius, large\",-58.6,-14.1,231,0.01,0.01,1\nM,,-50.5,-6.3,156,0.01,0.01,1\n"
        + "L,Longomontanus,-49.5,-21.8,145,0.01,0.01,1\nfar,,40,170,300,0.1,0.1,1\nsmall,,-46,-12,2,0.01,0.01,0.1\n";

    private readonly TemporaryFolder _folder = new();

    public NavigationRunTests() => _folder.Write("c.csv", Catalogue);

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.Ldem4)]
    public void Run_Craters_AreTheSameInAllFiles()
    {
        CommandLineRun run = Run(
            "out", "--craters", _folder["c.csv"], "--rendering-annotation", "--layers", "crater", "--layers-format", "npy");
        Assert.True(run.ExitCode == 0, run.Error);
        string stem = Path.Combine(_folder["out"], "MoonSurfIllumSim_step_00001");
        XElement information = MetaFileXml.Parse(File.ReadAllText($"{stem}.xml")).Descendants("CraterInformation").Single();
        XElement[] craters = [.. information.Elements("Crater")];
        string[][] lines =
        [
            .. File.ReadLines($"{stem}.craters.csv")
                .Select(line => line.Replace("\"Clavius, large\"", "Clavius", StringComparison.Ordinal).Split(',')),
        ];
        using JsonDocument json = JsonDocument.Parse(File.ReadAllBytes($"{stem}.craters.json"));
        JsonElement[] annotations = [.. json.RootElement.GetProperty("annotations").EnumerateArray()];

        Assert.Equal(["T", "C", "M", "L"], craters.Select(crater => crater.Attribute("id")!.Value));
        Assert.Equal("1", information.Attribute("tooSmall")!.Value);
        for (int i = 0; i < craters.Length; i++)
        {
            foreach (string name in (string[])["h", "v", "semiMajor", "semiMinor", "turn", "inside", "hidden", "lit", "emission"])
            {
                string value = craters[i].Attribute(name)!.Value;
                Assert.Equal(value, lines[i + 1][Array.IndexOf(lines[0], name)]);
                Assert.Equal(Number(value), annotations[i].GetProperty("crater").GetProperty(name).GetDouble());
            }

            double[] covariance = [.. craters[i].Attribute("covariance")!.Value.Split(' ').Select(Number)];
            Assert.Equal(25, covariance.Length);
            Assert.Equal(covariance[8], Number(lines[i + 1][Array.IndexOf(lines[0], "cov_v_semiMinor")]));
            double[] box = [.. annotations[i].GetProperty("bbox").EnumerateArray().Select(number => number.GetDouble())];
            Assert.True(box[0] >= 0.0 && box[1] >= 0.0 && box[0] + box[2] <= Width && box[1] + box[3] <= Height);
            double[] polygon = [.. annotations[i].GetProperty("segmentation")[0].EnumerateArray().Select(number => number.GetDouble())];
            // a polygon in place of an ellipse, cut off at the image
            Assert.Equal(annotations[i].GetProperty("area").GetDouble(), Area(polygon), 0.01 * box[2] * box[3]);
        }

        int[] numbers = Numbers($"{stem}.crater.npy");
        Assert.Equal(1, numbers[((int)Number(craters[0].Attribute("v")!.Value) * Width) + (int)Number(craters[0].Attribute("h")!.Value)]);
        Assert.Equal([0, 1, 2, 3, 4], numbers.Distinct().Order());
        Assert.NotEqual(File.ReadAllBytes($"{stem}.png"), File.ReadAllBytes($"{stem}.annotated.png"));
        Assert.Contains("kind=\"crater-catalogue\" name=\"c.csv\"", File.ReadAllText($"{stem}.xml"), StringComparison.Ordinal);
    }

    /// <summary>A frame without the option has the bytes that it always had, but for the words of its own command line.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_WithoutCraters_HasTheSameImageAndNoDeclaration()
    {
        Assert.Equal(0, Run("with", "--craters", _folder["c.csv"], "--layers", "all", "--layers-format", "npy").ExitCode);
        Assert.Equal(0, Run("without", "--layers", "all", "--layers-format", "npy").ExitCode);
        string[] with = [.. Directory.GetFiles(_folder["with"]).Select(path => Path.GetFileName(path))];
        string[] without = [.. Directory.GetFiles(_folder["without"]).Select(path => Path.GetFileName(path))];

        Assert.Equal(
            [".crater.npy", ".craters.csv", ".craters.json"],
            with.Except(without).Select(name => name["MoonSurfIllumSim_step_00001".Length..]).Order(StringComparer.Ordinal));
        Assert.All(
            without.Where(name => name.EndsWith(".npy", StringComparison.Ordinal) || name.EndsWith(".png", StringComparison.Ordinal)),
            name => Assert.Equal(File.ReadAllBytes(_folder[$"with/{name}"]), File.ReadAllBytes(_folder[$"without/{name}"])));
        Assert.DoesNotContain(
            "Crater", File.ReadAllText(_folder["without/MoonSurfIllumSim_step_00001.xml"]), StringComparison.Ordinal);
    }

    /// <summary>The projection of docs/camera-model.md, by the camera that the meta file has.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_Landmarks_AreWhereTheMetaFilesCameraProjectsThem()
    {
        _folder.Write("l.csv", "id,lat,lon,height\na,-48,-12,\nb,-51.5,-14,2500\nfar,-48,-12,2000000\n");
        CommandLineRun run = Run("out", "--landmarks", _folder["l.csv"], "--rendering-annotation");
        Assert.True(run.ExitCode == 0, run.Error);
        string stem = Path.Combine(_folder["out"], "MoonSurfIllumSim_step_00001");
        XDocument document = MetaFileXml.Parse(File.ReadAllText($"{stem}.xml"));
        XElement information = document.Descendants("LandmarkInformation").Single();
        double[] k = Numbers(document.Descendants("K").Single());
        double[] r = Numbers(document.Descendants("R").Single());
        double[] t = Numbers(document.Descendants("t").Single());
        string[][] lines = [.. File.ReadLines($"{stem}.landmarks.csv").Select(line => line.Split(','))];

        Assert.Equal("1", information.Attribute("outside")!.Value);
        Assert.Equal(["a", "b"], information.Elements("Landmark").Select(landmark => landmark.Attribute("id")!.Value));
        foreach (XElement landmark in information.Elements("Landmark"))
        {
            double Value(string name) => Number(landmark.Attribute(name)!.Value);
            double[] point = [Value("x"), Value("y"), Value("z")];
            double[] inCamera =
                [.. Enumerable.Range(0, 3).Select(row => t[row] + point.Select((part, i) => r[(3 * row) + i] * part).Sum())];
            Assert.Equal(((k[0] * inCamera[0]) / inCamera[2]) + k[2] + 1.0, Value("h"), Rounding.OfConvertedPlaces);
            Assert.Equal(((k[4] * inCamera[1]) / inCamera[2]) + k[5] + 1.0, Value("v"), Rounding.OfConvertedPlaces);
            Assert.Equal("yes", landmark.Attribute("visible")!.Value);
            string[] line = lines.Single(fields => fields[1] == landmark.Attribute("id")!.Value);
            Assert.All(landmark.Attributes(), attribute =>
                Assert.Equal(attribute.Value, line[Array.IndexOf(lines[0], attribute.Name.LocalName)]));
        }

        Assert.Equal(2500.0, Number(lines[2][Array.IndexOf(lines[0], "height")]), Rounding.OfConvertedPlaces);
    }

    /// <summary>
    /// The other formats hold the numbers of the arrays; a frame's own command line, and the other's meta file as target, give the same.
    /// </summary>
    [RequiresFact(Part.Ldem4, Part.CFitsio)]
    public void Run_Flow_IsTheSameInAllFormatsAndAgain()
    {
        _folder.Write("b.csv", "time,lat,lon,height\n2010-03-25T06:00:00Z,-50,-12,500000\n2010-03-25T06:30:00Z,-49.5,-12.5,480000\n");
        string[] series = ["--renderer", "native", "--batch-file", _folder["b.csv"], "--fov", "60", "--width", "64", "--height", "48"];
        string[] formats = ["--stereo", "20000", "--flow-format", "fits,npy,flo,kitti"];
        Assert.Equal(0, CommandLineRun.Of([.. series, "--flow", "next", .. formats, "--output-dir", _folder["all"]]).ExitCode);
        string stem = Path.Combine(_folder["all"], "MoonSurfIllumSim_step_00001");
        double[] flow = Doubles($"{stem}.flow.npy", 2 * 64 * 48);
        byte[] classes = File.ReadAllBytes($"{stem}.flow-class.npy")[^(64 * 48)..];
        byte[] middlebury = File.ReadAllBytes($"{stem}.flow.flo");
        double[] disparity = Doubles($"{stem}.disparity.npy", 64 * 48);

        Assert.Equal("PIEH"u8.ToArray(), middlebury[..4]);
        Assert.Equal((64, 48), (BitConverter.ToInt32(middlebury, 4), BitConverter.ToInt32(middlebury, 8)));
        Assert.Equal(12 + (8 * 64 * 48), middlebury.Length);
        for (int i = 0; i < 64 * 48; i++)
        {
            Assert.Equal((float)flow[2 * i], BitConverter.ToSingle(middlebury, 12 + (8 * i)));
            Assert.Equal((float)flow[(2 * i) + 1], BitConverter.ToSingle(middlebury, 16 + (8 * i)));
        }

        Assert.Equal([1, 3], classes.Distinct().Order().Select(value => (int)value));
        Assert.All(disparity, value => Assert.InRange(value, 1.0, 5.0)); // 55.4 px of focal length x 20 km / 500 km
        Assert.False(File.Exists(Path.Combine(_folder["all"], "MoonSurfIllumSim_step_00002.flow.npy")), "nothing comes after the last");
        Assert.True(File.Exists(Path.Combine(_folder["all"], "MoonSurfIllumSim_step_00002.disparity.png")));

        string[] alone = ["--frames", "1", "--flow-format", "npy", "--output-dir"];
        string other = Path.Combine(_folder["all"], "MoonSurfIllumSim_step_00002.xml");
        Assert.Equal(0, CommandLineRun.Of([.. series, "--flow", other, .. alone, _folder["file"]]).ExitCode);
        Assert.Equal(
            File.ReadAllBytes($"{stem}.flow.npy"), File.ReadAllBytes(_folder["file/MoonSurfIllumSim_step_00001.flow.npy"]));
        string command = MetaFileXml.Parse(File.ReadAllText($"{stem}.xml")).Descendants("CommandLine").Single().Value;
        Assert.EndsWith($" --flow '{{{string.Join(',', StateOf(other))}}}'", command, StringComparison.Ordinal);
        string[] words = [.. command.Split('\'').SelectMany((part, i) => i % 2 == 1 ? [part] : part.Split(' '))];
        Assert.Equal(0, CommandLineRun.Of([.. words.Where(word => word.Length > 0), "--output-dir", _folder["again"]]).ExitCode);
        Assert.Equal(
            File.ReadAllBytes($"{stem}.flow.fits"), File.ReadAllBytes(_folder["again/MoonSurfIllumSim_step_00001.flow.fits"]));
    }

    /// <summary>With a detector the frame is drawn with a margin, which a flow does not have.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_FlowWithADetector_IsThatWithout()
    {
        const string camera = "focal-length: 5\npixel-pitch: 0.05\nwidth: 64\nheight: 48\nprincipal-point: [20, 30]\n";
        _folder.Write("plain.yaml", camera);
        _folder.Write("detector.yaml", camera + "detector:\n  " + string.Join(
            "\n  ", "f-number: 40", "exposure-time: 0.05", "band: [500, 650]", "quantum-efficiency: 0.45", "psf: gaussian",
            "psf-sigma: 0.9", "psf-radius: 4", "full-well: 20000", "adc-bits: 12", "gain: 10", "bias: 64", "read-noise: 12", "seed: 7",
            "fits: no") + "\n");
        const string target = "{55280.3,990000,-250000,-2000000,"
            + "-0.09174722774522856,0.7132528187887395,-0.044164349618345956,0.6934712488011102}";
        foreach (string name in (string[])["plain", "detector"])
        {
            CommandLineRun run = CommandLineRun.Of(
            [
                "--renderer", "native", "--position", "-56,-14,500000", "--look-at", "-52,-12", "--time", "2010-03-25T06:00:00Z",
                "--camera", _folder[$"{name}.yaml"], "--flow", target, "--flow-format", "npy", "--output-dir", _folder[name],
            ]);
            Assert.True(run.ExitCode == 0, run.Error);
        }

        double[] plain = Doubles(_folder["plain/MoonSurfIllumSim_step_00001.flow.npy"], 2 * 64 * 48);
        double[] detected = Doubles(_folder["detector/MoonSurfIllumSim_step_00001.flow.npy"], 2 * 64 * 48);
        Assert.All(plain.Zip(detected), pair => Assert.Equal(pair.First, pair.Second, 1e-9)); // its rays are rounded anew
        Assert.Contains(plain, double.IsFinite);
        foreach (string layer in (string[])["flow-class", "flow-light"])
        {
            Assert.Equal(
                File.ReadAllBytes(_folder[$"plain/MoonSurfIllumSim_step_00001.{layer}.npy"]),
                File.ReadAllBytes(_folder[$"detector/MoonSurfIllumSim_step_00001.{layer}.npy"]));
        }
    }

    [Theory]
    [InlineData("--flow next", "--flow next leads to another image of the run, but that has one only.")]
    [InlineData("--flow FILE:none.xml", "none.xml: there is no such file. Give next, previous, pair, a meta file or a state")]
    [InlineData("--flow FILE:bad.csv", "bad.csv: no meta file, or it does not say what made it.")]
    [InlineData("--flow {1,2}", "--flow: 2 numbers, 8 expected")]
    [InlineData("--flow-format npy", "--flow-format is given, but no --flow that it is for.")]
    [InlineData("--stereo 1 --flow-format avi", "'avi' is not a format. Give some of fits, npy, flo, kitti.")]
    [InlineData("--stereo 0", "--stereo is 0; its range is above 0")]
    [InlineData("--landmarks FILE:c.csv --renderer povray", "--landmarks is for --renderer native only.")]
    [InlineData("--landmarks FILE:bad.txt", "bad.txt, line 1: no column for latitude and longitude, nor x, y and z")]
    [InlineData("--landmarks FILE:nan.txt", "nan.txt, line 2, column 'lat': a number from -90 to 90 is needed")]
    [InlineData("--crater-rim terrain", "--crater-rim is given, but no --craters. Name a catalogue, or leave it out.")]
    [InlineData("--layers crater", "--layers: crater needs a catalogue of craters. Name one by --craters.")]
    [InlineData("--craters FILE:none.csv", "there is no such file. A catalogue of craters in CSV is needed.")]
    [InlineData("--craters FILE:c.csv --renderer povray", "--craters is for --renderer native only.")]
    [InlineData("--craters FILE:c.csv --crater-size -1", "--crater-size is -1; its range is 0 to 100000.")]
    [InlineData("--craters FILE:bad.csv", "bad.csv, line 3: the crater 'a' is already in line 2. Remove one.")]
    public void Run_WrongOption_SaysSoAndLeavesNothing(string options, string message)
    {
        _folder.Write("bad.txt", "a,b\n1,2\n");
        _folder.Write("nan.txt", "lat,lon\nnan,2\n");
        _folder.Write("bad.csv", "id,lat,lon,diam_km\na,1,2,3\na,4,5,6\n");

        CommandLineRun run = Run(
            "out", [.. options.Split(' ').Select(word => word.Replace("FILE:", $"{_folder.Path}/", StringComparison.Ordinal))]);

        Assert.InRange(run.ExitCode, 1, 2);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(_folder["out"]));
    }

    /// <summary>
    /// The layer position, landmarks, craters and cameras over the terrain have one ground: what the layer says of a pixel's middle is
    /// where a landmark of that latitude and longitude lies, at the pixel's middle.
    /// </summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_GroundOfAPixel_IsThatOfLandmarksCratersAndCameras()
    {
        const double OverGround = 1000.0; // m
        Assert.Equal(0, Run("layer", "--layers", "position", "--layers-format", "npy").ExitCode);
        double[] positions = Doubles(Path.Combine(_folder["layer"], "MoonSurfIllumSim_step_00001.position.npy"));
        int[] pixels = [.. Enumerable.Range(0, Width * Height).Where(pixel => pixel % 37 == 0 && double.IsFinite(positions[3 * pixel]))];
        string[] places = [.. pixels.Select(pixel => Place(positions.AsSpan(3 * pixel, 3)))];
        _folder.Write("l.csv", "id,lat,lon\n" + string.Concat(pixels.Zip(places, (pixel, place) => $"{pixel},{place}\n")));
        _folder.Write("c.csv", "id,lat,lon,diam_km\n" + string.Concat(pixels.Zip(places, (pixel, place) => $"{pixel},{place},40\n")));
        string[] cameraRows = [.. places.Select((place, i) => $"{60 * i},{place},terrain+{OverGround:F0}\n")];
        _folder.Write("b.csv", "seconds,lat,lon,height\n" + string.Concat(cameraRows));

        Assert.Equal(0, Run("lists", "--landmarks", _folder["l.csv"], "--craters", _folder["c.csv"]).ExitCode);
        CommandLineRun states = CommandLineRun.Of(
        [
            "batchconvert", "--batch-file", _folder["b.csv"], "--epoch", "55280", "--format", "sh", "--pieces", "1", "--script",
            _folder["s.sh"],
        ]);

        Assert.True(states.ExitCode == 0, states.Error);
        string stem = Path.Combine(_folder["lists"], "MoonSurfIllumSim_step_00001");
        Dictionary<string, string>[] landmarks = Table($"{stem}.landmarks.csv");
        Dictionary<string, string>[] craters = Table($"{stem}.craters.csv");
        double[] cameras =
        [
            .. File.ReadLines(_folder["s.sh.states.tab"]).Where(line => line[0] != '#')
                .Select(line => Norm([.. line.Split(' ')[1..4].Select(Number)])),
        ];
        Assert.InRange(pixels.Length, 100, 400);
        Assert.Equal(pixels.Length, cameras.Length);
        Assert.Equal(pixels.Length, landmarks.Length);
        Assert.InRange(craters.Length, pixels.Length / 2, pixels.Length); // those on the limb are too narrow to be told
        for (int i = 0; i < pixels.Length; i++)
        {
            double[] position = positions[(3 * pixels[i])..((3 * pixels[i]) + 3)];
            Dictionary<string, string> landmark = landmarks.Single(row => Number(row["id"]) == pixels[i]);
            Assert.Equal("yes", landmark["visible"]);
            Assert.Equal(1.0 + (pixels[i] % Width), Number(landmark["h"]), 1e-6);
            Assert.Equal(1.0 + (pixels[i] / Width), Number(landmark["v"]), 1e-6);
            Assert.Equal(position[0], Number(landmark["x"]), OneGround);
            Assert.Equal(position[1], Number(landmark["y"]), OneGround);
            Assert.Equal(position[2], Number(landmark["z"]), OneGround);
            Assert.Equal(Norm(position), cameras[i] - OverGround, OneGround);
        }

        foreach (Dictionary<string, string> crater in craters)
        {
            int pixel = (int)Number(crater["id"]);
            Assert.Equal(Norm(positions[(3 * pixel)..((3 * pixel) + 3)]), 1_737_400.0 + Number(crater["height"]), OneGround);
        }

        static string Place(ReadOnlySpan<double> r)
        {
            double latitude = double.RadiansToDegrees(Math.Atan2(r[2], Math.Sqrt((r[0] * r[0]) + (r[1] * r[1]))));
            return FormattableString.Invariant($"{latitude},{double.RadiansToDegrees(Math.Atan2(r[1], r[0]))}");
        }

        static double Norm(double[] r) => Math.Sqrt((r[0] * r[0]) + (r[1] * r[1]) + (r[2] * r[2]));
    }

    private CommandLineRun Run(string output, params string[] options) => CommandLineRun.Of(
    [
        .. options.Contains("--renderer") ? (string[])[] : ["--renderer", "native"],
        "--position", "-50,-12,500000", "--time", "2010-03-25T06:00:00Z", "--fov", "60", "--width", $"{Width}", "--height", $"{Height}",
        "--output-dir", _folder[output], .. options,
    ]);

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    private static double[] Numbers(XElement element) =>
        [.. element.Value.Split((char[])[' ', '\n'], StringSplitOptions.RemoveEmptyEntries).Select(Number)];

    private static double Area(double[] polygon)
    {
        double twice = 0.0;
        for (int i = 0; i < polygon.Length; i += 2)
        {
            int next = (i + 2) % polygon.Length;
            twice += (polygon[i] * polygon[next + 1]) - (polygon[next] * polygon[i + 1]);
        }

        return Math.Abs(0.5 * twice);
    }

    /// <summary>The numbers of the state in a meta file's command line, as they stand there.</summary>
    private static string[] StateOf(string metaFile) =>
        MetaFileXml.Parse(File.ReadAllText(metaFile)).Descendants("CommandLine").Single().Value.Split('{', '}')[1].Split(',');

    private static double[] Doubles(string path, int count)
    {
        byte[] bytes = File.ReadAllBytes(path);
        double[] numbers = new double[count];
        Buffer.BlockCopy(bytes, bytes.Length - (sizeof(double) * count), numbers, 0, sizeof(double) * count);
        return numbers;
    }

    /// <summary>The last numbers of an array file.</summary>
    private static double[] Doubles(string path)
    {
        byte[] bytes = File.ReadAllBytes(path);
        double[] numbers = new double[3 * Width * Height];
        Buffer.BlockCopy(bytes, bytes.Length - (sizeof(double) * numbers.Length), numbers, 0, sizeof(double) * numbers.Length);
        return numbers;
    }

    private static Dictionary<string, string>[] Table(string path)
    {
        string[][] lines = [.. File.ReadLines(path).Select(line => line.Split(','))];
        return [.. lines[1..].Select(fields => lines[0].Zip(fields).ToDictionary())];
    }

    private static int[] Numbers(string path)
    {
        byte[] bytes = File.ReadAllBytes(path);
        int[] numbers = new int[Width * Height];
        Buffer.BlockCopy(bytes, bytes.Length - (sizeof(int) * numbers.Length), numbers, 0, sizeof(int) * numbers.Length);
        return numbers;
    }
}
