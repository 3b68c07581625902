using System.Globalization;
using System.Text.Json;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Numerics;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.DataSets;

/// <summary>Data sets from end to end: images, index, card; again, restarted, damaged.</summary>
public sealed class DataSetRunTests : IDisposable
{
    private const string File1 =
        """
        name: A | trial
        licence: CC0
        count: 8
        seed: 3
        index: [csv, coco, tum, kitti]
        states:
          latitude: [-50, 50]
          altitude: log-uniform 200e3 400e3
          off-nadir: [5, 20]
          roll: [0, 360]
          sun-elevation: [10, 60]
        accept: {ground: 1, lit: 0.6}
        split: {train: 0.5, test: 0.5, width: 60, gap: 2}
        licences: {c.csv: public domain}
        options:
          width: 48
          height: 36
          fov: 30
          albedo-map: none
          layers: [depth, latitude, longitude, mask]
          craters: c.csv
          crater-size: 2

        """;

    private readonly TemporaryFolder _folder = new();

    public DataSetRunTests()
    {
        _folder.Write("a.yaml", File1);
        _folder.Write("c.csv", "lat,lon,diam_km\n" + string.Concat(
            from latitude in Enumerable.Range(-10, 21)
            from longitude in Enumerable.Range(0, 72)
            select string.Create(CultureInfo.InvariantCulture, $"{5 * latitude},{5 * longitude},40\n")));
    }

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.Ldem4)]
    public void Run_WholeSet_HasWhatTheFileAsks()
    {
        Assert.Equal(0, Make("a", "out").ExitCode);
        string[][] index = [.. File.ReadLines(_folder["out/index.csv"]).Select(line => line.Split(','))];
        double[] Column(string name) =>
            [.. index.Skip(1).Select(row => double.Parse(row[Array.IndexOf(index[0], name)], CultureInfo.InvariantCulture))];

        Assert.Equal(["train", "test", "train", "test", "train", "test", "train", "test"], index.Skip(1).Select(row => row[2]));
        Assert.All(Column("altitude"), value => Assert.InRange(value, 200e3, 400e3));
        Assert.All(Column("sun_elevation"), value => Assert.InRange(value, 10.0, 60.0));
        Assert.All(Column("latitude"), value => Assert.InRange(value, -50.0, 50.0));
        Assert.All(Column("ground"), value => Assert.Equal(1.0, value));
        for (int number = 1; number <= 8; number++)
        {
            CheckState(Column, number);
        }

        Assert.Empty(Meridians(index, "train").Intersect(Meridians(index, "test")));
        CheckIndexes(index);
        Assert.Contains("# A | trial", File.ReadAllText(_folder["out/card.md"]), StringComparison.Ordinal);
        Assert.StartsWith("<svg", File.ReadAllText(_folder["out/card.svg"]), StringComparison.Ordinal);
        CommandLineRun verified = CommandLineRun.Of(["verify", _folder["out"]]);
        Assert.Equal("8 frames: 8 complete.\n", verified.Output.ReplaceLineEndings("\n"));
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_SingleImageAndRestart_GiveTheSameBytes()
    {
        Assert.Equal(0, Make("a", "out").ExitCode);
        Assert.Equal(0, Make("a", "again", "--frames", "6").ExitCode);
        string[] again = [.. Directory.GetFiles(_folder["again"], "000006*")];
        Assert.Equal(9, again.Length);
        Assert.All(again, path => Assert.Equal(File.ReadAllBytes(path), File.ReadAllBytes(_folder[$"out/{Path.GetFileName(path)}"])));
        Assert.False(File.Exists(_folder["again/card.md"]), "a part of a data set has no card");

        byte[] card = File.ReadAllBytes(_folder["out/card.json"]);
        File.Delete(_folder["out/000002.depth.npy"]);
        File.AppendAllText(_folder["out/index.csv"], "x");
        CommandLineRun damaged = CommandLineRun.Of(["verify", _folder["out"]]);
        Assert.Equal(5, damaged.ExitCode);
        Assert.Contains("2\t000002\tdamaged\t000002.depth.npy: missing", damaged.Output, StringComparison.Ordinal);
        Assert.Contains("-\tindex.csv\tdamaged\t", damaged.Output, StringComparison.Ordinal);
        Assert.Equal(0, Make("a", "out").ExitCode);
        Assert.Equal(0, CommandLineRun.Of(["verify", _folder["out"]]).ExitCode);
        Assert.Equal(card, File.ReadAllBytes(_folder["out/card.json"]));

        _folder.Write("a.yaml", File1.Replace("seed: 3", "seed: 4", StringComparison.Ordinal));
        CommandLineRun other = Make("a", "out");
        Assert.Equal(1, other.ExitCode);
        Assert.Contains("another data set, or another state of this one, is there", other.Error, StringComparison.Ordinal);
        Assert.Equal(0, CommandLineRun.Of(["verify", _folder["out"]]).ExitCode);
    }

    /// <summary>
    /// A ray of its own through each pixel of each image, against each facet of the real Moon: none meets ground beyond the image's region,
    /// though the regions are hardly larger than an image.
    /// </summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_NarrowRegions_NoPixelShowsGroundBeyondThem()
    {
        const int width = 150;
        const int height = 100;
        _folder.Write("r.yaml", $$"""
            count: {{TestLength.Of(8, 60)}}
            states: {altitude: 300e3, off-nadir: [0, 20], roll: [0, 360], sun-elevation: 30}
            accept: {ground: 1}
            split: {a: [-12, 0, 0, 12], b: [2, 14, 0, 12]}
            options: {width: {{width}}, height: {{height}}, fov: 40, albedo-map: none, lod: off}

            """);
        CommandLineRun run = Make("r", "regions");
        Assert.True(run.ExitCode == 0, run.Error);
        string[][] index = [.. File.ReadLines(_folder["regions/index.csv"]).Select(line => line.Split(','))];
        using LdemImage grid = LdemImage.Open(LdemLabelReader.ReadFile(TestParts.Ldem4Label!));
        BruteForceMoon moon = new(grid);
        double focal = 0.5 * width / Math.Tan(20.0 * Math.PI / 180.0);
        double nearest = double.PositiveInfinity;
        foreach (string[] row in index.Skip(1))
        {
            double Of(string name) => Number(row[Array.IndexOf(index[0], name)]);
            Vector3D camera = new(Of("x"), Of("y"), Of("z"));
            UnitQuaternion turn = UnitQuaternion.FromComponents(Of("qx"), Of("qy"), Of("qz"), Of("q0"));
            (double south, double north) = row[2] == "a" ? (-12.0, 0.0) : (2.0, 14.0);
            for (int pixel = 0; pixel < width * height; pixel++)
            {
                // Camera axes: -x ahead, y to the right, z up; the optical axis is in the middle of the image.
                (int column, int line) = (pixel % width, pixel / width);
                Vector3D direction =
                    turn * new Vector3D(-1.0, (column - (0.5 * (width - 1))) / focal, ((0.5 * (height - 1)) - line) / focal);
                Vector3D point = camera + (moon.FirstHit(camera, direction)!.Value.T * direction);
                double latitude = Math.Atan2(point.Z, Math.Sqrt((point.X * point.X) + (point.Y * point.Y))) * 180.0 / Math.PI;
                double longitude = Math.Atan2(point.Y, point.X) * 180.0 / Math.PI;
                double room = Math.Min(Math.Min(latitude - south, north - latitude), Math.Min(longitude, 12.0 - longitude));
                Assert.True(room >= 0.0, $"{row[1]}, pixel {pixel}: {latitude}, {longitude}");
                nearest = Math.Min(nearest, room);
            }
        }

        Assert.InRange(nearest, 0.0, 0.5); // degrees: the regions are filled to their borders
    }

    /// <summary>More images: the first ones, their splits and their bytes are those of the smaller data set, which goes on.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_MoreImages_KeepsTheFirst()
    {
        string yaml = File1.Replace("count: 8", "count: 4", StringComparison.Ordinal)
            .Replace("train: 0.5, test: 0.5", "train: 0.7, test: 0.3", StringComparison.Ordinal);
        _folder.Write("a.yaml", yaml);
        Assert.Equal(0, Make("a", "out").ExitCode);
        string[] states = File.ReadAllLines(_folder["out/states.csv"]);
        string[][] index = [.. File.ReadLines(_folder["out/index.csv"]).Select(line => line.Split(','))];
        DateTime written = File.GetLastWriteTimeUtc(_folder["out/000003.png"]);

        _folder.Write("a.yaml", yaml.Replace("count: 4", "count: 9", StringComparison.Ordinal));
        CommandLineRun more = Make("a", "out");
        Assert.True(more.ExitCode == 0, more.Error);
        Assert.Equal(states, File.ReadLines(_folder["out/states.csv"]).Take(states.Length));
        Assert.Equal(index, File.ReadLines(_folder["out/index.csv"]).Take(5).Select(line => line.Split(',')));
        Assert.Equal(written, File.GetLastWriteTimeUtc(_folder["out/000003.png"]));
        Assert.Equal(10, File.ReadLines(_folder["out/index.csv"]).Count());
        Assert.Equal("9 frames: 9 complete.", CommandLineRun.Of(["verify", _folder["out"]]).Output.Trim());

        Assert.Equal(0, Make("a", "fresh").ExitCode);
        Assert.All(
            (string[])["index.csv", "000002.png", "000008.png", "train.coco.json"],
            name => Assert.Equal(File.ReadAllBytes(_folder[$"fresh/{name}"]), File.ReadAllBytes(_folder[$"out/{name}"])));

        _folder.Write("a.yaml", yaml);
        CommandLineRun fewer = Make("a", "out");
        Assert.Equal(1, fewer.ExitCode);
        Assert.Contains("more images of this data set are there than 'count' says. Set 'count' to at least 9", fewer.Error);
        _folder.Write("a.yaml", yaml.Replace("count: 4", "count: 9", StringComparison.Ordinal)); // as the message says
        Assert.Equal(0, Make("a", "out").ExitCode);
    }

    /// <summary>COCO's files of 500 images, by a reader of the format's rules: craters cut by borders, hidden and dark ones.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_CocoOfManyImages_KeepsTheRulesOfTheFormat()
    {
        int count = TestLength.Of(16, 500);
        _folder.Write("m.yaml", File1.Replace("count: 8", $"count: {count}", StringComparison.Ordinal)
            .Replace("off-nadir: [5, 20]", "off-nadir: [0, 75]", StringComparison.Ordinal)
            .Replace("accept: {ground: 1, lit: 0.6}", "accept: {ground: 0.3}", StringComparison.Ordinal)
            .Replace("sun-elevation: [10, 60]", "sun-elevation: [-2, 30]", StringComparison.Ordinal)
            .Replace("split: {train: 0.5, test: 0.5, width: 60, gap: 2}\n", string.Empty, StringComparison.Ordinal)
            .Replace("layers: [depth, latitude, longitude, mask]", "crater-rim: terrain", StringComparison.Ordinal));
        CommandLineRun run = Make("m", "many");
        Assert.True(run.ExitCode == 0, run.Error);
        CocoRules rules = CocoRules.Check(_folder["many/all.coco.json"]);

        Assert.Equal(count, rules.Images);
        Assert.InRange(rules.Annotations, 2 * count, int.MaxValue);
        Assert.InRange(rules.CutInside, 1, rules.Annotations); // whose box is not the cut one of the whole ellipse
        Assert.InRange(rules.Ignored, 1, rules.Annotations / 2);
        Assert.Equal(
            rules.Annotations, Directory.GetFiles(_folder["many"], "*.craters.json").Sum(path => CocoRules.Check(path).Annotations));
    }

    /// <summary>Images that are too large are refused before anything is made, and what was there stays as it was.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_RefusedForRoom_LeavesNothingBehind()
    {
        string huge = File1.Replace("width: 48", "width: 8192\n  jobs: 64", StringComparison.Ordinal)
            .Replace("height: 36", "height: 8192", StringComparison.Ordinal)
            .Replace("count: 8", "count: 64", StringComparison.Ordinal);
        _folder.Write(
            "h.yaml", huge.Replace("split: {train: 0.5, test: 0.5, width: 60, gap: 2}\n", string.Empty, StringComparison.Ordinal));
        CommandLineRun refused = Make("h", "deep/out");
        Assert.Equal(2, refused.ExitCode);
        Assert.Contains("Use a smaller --width and --height", refused.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(_folder["deep"]));

        Directory.CreateDirectory(_folder["mine"]);
        _folder.Write("mine/notes.txt", "x");
        Assert.Equal(2, Make("h", "mine").ExitCode);
        Assert.Equal([_folder["mine/notes.txt"]], Directory.GetFileSystemEntries(_folder["mine"]));
    }

    /// <summary>The second image of a pair is as far away as the file says, and flows lead there and back.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_Pairs_FlowThereAndBack()
    {
        _folder.Write("p.yaml", """
            count: 2
            sampling: random
            states: {latitude: [-30, 30], altitude: 300000, sun-elevation: 40, exposure-factor: [0.5, 2]}
            pair: {shift: [9000, 10000], turn: 1}
            accept: {ground: 1}
            options: {width: 40, height: 40, fov: 40, albedo-map: none, lod: off}

            """);
        CommandLineRun run = Make("p", "pairs");
        Assert.True(run.ExitCode == 0, run.Error);
        string[][] index = [.. File.ReadLines(_folder["pairs/index.csv"]).Skip(1).Select(line => line.Split(','))];
        string[] head = File.ReadLines(_folder["pairs/index.csv"]).First().Split(',');
        Assert.Equal(4, index.Length);
        foreach (string[][] pair in index.Chunk(2))
        {
            double[] Place(string[] row) => [.. new[] { "x", "y", "z" }.Select(name => Number(row[Array.IndexOf(head, name)]))];
            double shift = Math.Sqrt(Place(pair[0]).Zip(Place(pair[1]), (a, b) => (a - b) * (a - b)).Sum());
            Assert.Equal(Number(pair[0][Array.IndexOf(head, "shift")]), shift, 1e-6); // m: the difference of two places of 2e6 m in text
            Assert.InRange(shift, 9000.0, 10000.0);
            double[][] flows = [.. pair.Select(row => Doubles(_folder[$"pairs/{row[0].PadLeft(6, '0')}.flow.npy"], 2 * 40 * 40))];
            int checkedPixels = 0;
            for (int y = 8; y < 32; y++)
            {
                for (int x = 8; x < 32; x++)
                {
                    double u = x + flows[0][2 * ((40 * y) + x)];
                    double v = y + flows[0][(2 * ((40 * y) + x)) + 1];
                    if (u is > 1.0 and < 38.0 && v is > 1.0 and < 38.0)
                    {
                        int there = (40 * (int)Math.Round(v)) + (int)Math.Round(u);
                        Assert.Equal(x, u + flows[1][2 * there], 0.6);
                        Assert.Equal(y, v + flows[1][(2 * there) + 1], 0.6);
                        checkedPixels++;
                    }
                }
            }

            Assert.True(checkedPixels > 300, $"{checkedPixels} pixels");
        }
    }

    /// <summary>
    /// The ephemeris's Sun, a camera with a detector, regions of the splits' own; noise and exposure are those of each image.
    /// </summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_DetectorAtRandomTimes_IsMadeAgainToTheByte()
    {
        const string camera = "focal-length: 5\npixel-pitch: 0.05\nwidth: 32\nheight: 24\ndetector:\n  ";
        _folder.Write("camera.yaml", camera + string.Join(
            "\n  ", "f-number: 40", "exposure-time: 0.05", "band: [500, 650]", "quantum-efficiency: 0.45", "full-well: 20000",
            "adc-bits: 12", "gain: 10", "bias: 64", "read-noise: 12", "fits: no") + "\n");
        _folder.Write("d.yaml", """
            count: 4
            states:
              altitude: 100e3
              off-nadir: 20
              time: uniform 2026-01-01T00:00:00Z 2027-01-01T00:00:00Z
              exposure-factor: [0.5, 2]
            accept: {lit: 0.3, sun-elevation: [5, 40]}
            split: {a: [-80, -60, 0, 180], b: [-50, 50, 0, 360]}
            options: {camera: camera.yaml, albedo-map: none, layers: mask}

            """);
        CommandLineRun run = Make("d", "out");
        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Equal(0, Make("d", "again", "--frames", "4").ExitCode);

        string[] states = File.ReadAllLines(_folder["out/states.csv"]);
        Assert.EndsWith(",noise_seed,exposure_factor", states[1], StringComparison.Ordinal);
        Assert.Equal(["1:1", "1:2", "1:3", "1:4"], states[2..].Select(line => line.Split(',')[^2]));
        Assert.All(Directory.GetFiles(_folder["again"], "000004*"), path =>
            Assert.Equal(File.ReadAllBytes(path), File.ReadAllBytes(_folder[$"out/{Path.GetFileName(path)}"])));
        string[] head = File.ReadLines(_folder["out/index.csv"]).First().Split(',');
        Assert.All(File.ReadLines(_folder["out/index.csv"]).Skip(1).Select(line => line.Split(',')), row =>
        {
            Assert.InRange(Number(row[Array.IndexOf(head, "sun_elevation")]), 5.0, 40.0);
            Assert.InRange(Number(row[Array.IndexOf(head, "mjd")]), 61041.0, 61406.0);
            Assert.Equal(Number(row[Array.IndexOf(head, "latitude")]) < -60.0 ? "a" : "b", row[2]);
        });
    }

    /// <summary>What the docs say: an image that is exposed twice as long has twice the linear levels.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_ExposureFactor_IsThatOfTheOption()
    {
        const string states =
            "time,lat,lon,height,exposure_factor\n2010-03-25T06:00:00Z,-40,-12,300000,1\n2010-03-25T06:00:00Z,-40,-12,300000,2\n";
        _folder.Write("b.csv", states);
        string[] options = ["--renderer", "native", "--width", "24", "--height", "24", "--bit-depth", "16", "--transfer", "linear"];
        string[] place =
            ["--position", "-40,-12,300000", "--time", "2010-03-25T06:00:00Z", "--output-name", "MoonSurfIllumSim_step_00002"];
        Assert.Equal(0, CommandLineRun.Of([.. options, "--batch-file", _folder["b.csv"], "--output-dir", _folder["series"]]).ExitCode);
        Assert.Equal(
            0, CommandLineRun.Of([.. options, .. place, "--exposure-factor", "2", "--output-dir", _folder["single"]]).ExitCode);
        Assert.Equal(0, CommandLineRun.Of([.. options, .. place, "--exposure", "10", "--output-dir", _folder["exposed"]]).ExitCode);

        byte[] doubled = File.ReadAllBytes(_folder["series/MoonSurfIllumSim_step_00002.png"]);
        Assert.NotEqual(File.ReadAllBytes(_folder["series/MoonSurfIllumSim_step_00001.png"]), doubled);
        Assert.Equal(File.ReadAllBytes(_folder["exposed/MoonSurfIllumSim_step_00002.png"]), doubled);
        Assert.Equal(
            File.ReadAllBytes(_folder["series/MoonSurfIllumSim_step_00002.xml"]),
            File.ReadAllBytes(_folder["single/MoonSurfIllumSim_step_00002.xml"]));
    }

    /// <summary>A data set with stars and the Earth's light: each image has its own list.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_Sky_HasTheStarsOfEachImage()
    {
        _folder.Write(
            "sky.yaml",
            """
            name: sky
            licence: CC0
            count: 2
            seed: 3
            index: [csv]
            states: {latitude: [-50, 50], altitude: log-uniform 200e3 400e3, off-nadir: [70, 75], sun-elevation: [10, 60]}
            options: {width: 48, height: 36, fov: 60, albedo-map: none, stars: bright, star-limit: 5, earthshine: true}

            """);

        CommandLineRun run = Make("sky", "out");

        Assert.True(run.ExitCode == 0, run.Error);
        string[] lists = [.. Directory.GetFiles(_folder["out"], "*.stars.csv").Order().Select(File.ReadAllText)];
        Assert.Equal(2, lists.Length);
        Assert.NotEqual(lists[0], lists[1]);
        Assert.All(lists, list => Assert.Contains("\nHIP ", list, StringComparison.Ordinal));
        Assert.Contains("bright.csv", File.ReadAllText(_folder["out/card.md"]), StringComparison.Ordinal);
    }

    private CommandLineRun Make(string name, string output, params string[] options) =>
        CommandLineRun.Of(["dataset", _folder[$"{name}.yaml"], "--output-dir", _folder[output], "--batch", .. options]);

    /// <summary>Place, height over the terrain and light of a state, from the numbers of the state alone.</summary>
    private void CheckState(Func<string, double[]> column, int number)
    {
        double Of(string name) => column(name)[number - 1];
        double[] camera = [Of("x"), Of("y"), Of("z")];
        double[] sun = [Of("sun_x"), Of("sun_y"), Of("sun_z")];
        double distance = Length(camera);
        double sine = camera.Zip(sun, (a, b) => a * b).Sum() / distance / Length(sun);
        Assert.Equal(Of("sun_elevation"), Math.Atan2(sine, Math.Sqrt(1.0 - (sine * sine))) * 180.0 / Math.PI, 0.01);
        double fromAxis = Math.Sqrt((camera[0] * camera[0]) + (camera[1] * camera[1]));
        Assert.Equal(Of("latitude"), Math.Atan2(camera[2], fromAxis) * 180.0 / Math.PI, Rounding.OfPlaces);
        Assert.InRange(distance - 1737400.0 - Of("altitude"), -10e3, 11e3);

        // Camera axes look along -x: the third row of a rotation by the quaternion's conjugate.
        (double x, double y, double z, double w) = (Of("qx"), Of("qy"), Of("qz"), Of("q0"));
        double[] forward = [-(1.0 - (2.0 * ((y * y) + (z * z)))), -2.0 * ((x * y) + (w * z)), -2.0 * ((x * z) - (w * y))];
        double cosine = -camera.Zip(forward, (a, b) => a * b).Sum() / distance;
        Assert.Equal(Of("off_nadir"), Math.Atan2(Math.Sqrt(1.0 - (cosine * cosine)), cosine) * 180.0 / Math.PI, 1e-6);
        byte[] mask = File.ReadAllBytes(_folder[$"out/{number:000000}.mask.npy"])[^(48 * 36)..];
        Assert.Equal(Of("lit"), mask.Count(value => value is 1 or 2) / (double)mask.Count(value => value > 0), Rounding.OfChains);
        Assert.True(Of("lit") >= 0.6, "as the condition asks");
    }

    /// <summary>The meridians that the images of a split show, in whole degrees.</summary>
    private HashSet<int> Meridians(string[][] index, string split) =>
    [
        .. index.Where(row => row[2] == split)
            .SelectMany(row => Doubles(_folder[$"out/{Path.GetFileNameWithoutExtension(row[1])}.longitude.npy"], 48 * 36))
            .Select(degrees => (int)Math.Floor(degrees)),
    ];

    private void CheckIndexes(string[][] index)
    {
        using JsonDocument coco = JsonDocument.Parse(File.ReadAllBytes(_folder["out/test.coco.json"]));
        JsonElement[] annotations = [.. coco.RootElement.GetProperty("annotations").EnumerateArray()];
        int[] images = [.. coco.RootElement.GetProperty("images").EnumerateArray().Select(image => image.GetProperty("id").GetInt32())];
        Assert.Equal([2, 4, 6, 8], images);
        Assert.Equal(annotations.Length, CocoRules.Check(_folder["out/test.coco.json"]).Annotations);
        Assert.Equal(Enumerable.Range(1, annotations.Length), annotations.Select(annotation => annotation.GetProperty("id").GetInt32()));
        foreach (int image in images)
        {
            int lines = File.ReadLines(_folder[$"out/{image:000000}.craters.csv"]).Count() - 1;
            Assert.True(lines > 0, "craters are in each image");
            Assert.Equal(
                CocoRules.Check(_folder[$"out/{image:000000}.craters.json"]).Annotations,
                annotations.Count(annotation => annotation.GetProperty("image_id").GetInt32() == image));
        }

        string[] poses = File.ReadAllLines(_folder["out/test.poses.txt"]);
        string[] truth = [.. File.ReadLines(_folder["out/test.groundtruth.txt"]).Skip(1)];
        int x = Array.IndexOf(index[0], "x");
        for (int i = 0; i < 4; i++)
        {
            int number = 2 * (i + 1);
            Assert.Equal(index[number][x], poses[i].Split(' ')[3]);
            Assert.Equal(index[number][x..(x + 3)], truth[i].Split(' ')[1..4]);
            Assert.StartsWith($"{number}.000000 ", truth[i], StringComparison.Ordinal);
        }

        Assert.Equal("2.000000 000002.png", File.ReadLines(_folder["out/test.rgb.txt"]).Skip(1).First());
        Assert.StartsWith("P0: 89.5", File.ReadAllText(_folder["out/test.calib.txt"]), StringComparison.Ordinal); // 24 / tan 15 degrees
    }

    private static double Length(double[] vector) => Math.Sqrt(vector.Sum(part => part * part));

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    private static double[] Doubles(string path, int count)
    {
        byte[] bytes = File.ReadAllBytes(path);
        double[] numbers = new double[count];
        Buffer.BlockCopy(bytes, bytes.Length - (sizeof(double) * count), numbers, 0, sizeof(double) * count);
        return numbers;
    }
}
