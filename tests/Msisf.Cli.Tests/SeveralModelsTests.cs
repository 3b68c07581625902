using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>Several elevation models in one scene, as a user has them.</summary>
public sealed class SeveralModelsTests : IDisposable
{
    internal const string View = "--fixed-state {51544.5,0,0,-3.2E6,0,0.7071067811865476,0,0.7071067811865476} --ignore-sun --batch "
        + "--width 40 --height 40 --fov 40";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Run_MapInAModelOfTheWholeMoon_IsDrawn()
    {
        CommandLineRun run = Draw("a", "--ldem", Moon(), "--ldem", Map(), "--lod", "off");

        Assert.Equal((0, string.Empty), (run.ExitCode, run.ExitCode == 0 ? string.Empty : run.Error));
        string xml = File.ReadAllText(Path.Combine(_folder["out"], "a.xml"));
        Assert.Contains("<ElevationPart part=\"0\" product=\"LDEM_2_SYNTHETIC\"", xml, StringComparison.Ordinal);
        Assert.Contains("<ElevationPart part=\"1\" product=\"LDEM_80S_10000M_SYNTHETIC\"", xml, StringComparison.Ordinal);
        Assert.Contains("--ldem LDEM_2_SYNTHETIC.LBL --ldem LDEM_80S_10000M_SYNTHETIC.LBL ", xml, StringComparison.Ordinal);
        Assert.DoesNotContain("--res ", xml, StringComparison.Ordinal);
        foreach (string part in (string[])["0", "1", "2"])
        {
            Assert.Contains($"<Facet part=\"{part}\" line=\"", xml, StringComparison.Ordinal); // both models, and the seam
        }

        Assert.DoesNotContain("tile=", xml, StringComparison.Ordinal);
    }

    [Fact]
    public void Run_OneModelByItsFile_HasTheResolutionOfTheFile()
    {
        string moon = Moon();
        CommandLineRun run = Draw("a", "--ldem", moon);

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Contains(" --res 2 ", File.ReadAllText(Path.Combine(_folder["out"], "a.xml")), StringComparison.Ordinal);
        Assert.Contains("but 16 px/deg are asked for", Draw("b", "--ldem", moon, "--res", "16").Error, StringComparison.Ordinal);
    }

    /// <summary>The order is no part of the content: a run with the same models in another order finds its image complete.</summary>
    [Fact]
    public void Run_ModelsInAnotherOrderOrInAFile_IsTheSame()
    {
        (string moon, string map) = (Moon(), Map());
        CommandLineRun first = Draw("a", "--ldem", moon, "--ldem", map);
        Assert.True(first.ExitCode == 0, first.Error);
        DateTime made = File.GetLastWriteTimeUtc(Path.Combine(_folder["out"], "a.png"));

        string config = _folder.Write("c.yaml", $"ldem: [{map}, {moon}]\n");
        CommandLineRun again = Draw("a", "--config", config);

        Assert.True(again.ExitCode == 0, again.Error);
        Assert.Equal(made, File.GetLastWriteTimeUtc(Path.Combine(_folder["out"], "a.png")));
    }

    [Fact]
    public void Run_LayerCell_HasThePartAsThirdPlane()
    {
        CommandLineRun run = Draw(
            "a", "--ldem", Moon(), "--ldem", Map(), "--layers", "cell,tile", "--layers-format", "npy", "--lod", "off");
        Assert.True(run.ExitCode == 0, run.Error);
        byte[] cell = File.ReadAllBytes(Path.Combine(_folder["out"], "a.cell.npy"));
        Assert.Contains("'shape': (40, 40, 3,)", System.Text.Encoding.ASCII.GetString(cell, 0, 128), StringComparison.Ordinal);
        int start = cell.Length - (40 * 40 * 3 * 4);
        int[] parts = [.. Enumerable.Range(0, 1600).Select(pixel => BitConverter.ToInt32(cell, start + (12 * pixel) + 8))];
        Assert.Equal([0, 1, 2], parts.Distinct().Order());
    }

    [Fact]
    public void DryRun_SeveralModels_TellsTheHeight()
    {
        CommandLineRun run = CommandLineRun.Of(
            [.. View.Split(' '), "--renderer", "native", "--dry-run", "--ldem", Moon(), "--ldem", Map()]);
        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Contains("2000-01-01", run.Output, StringComparison.Ordinal);
    }

    /// <summary>
    /// From 3,200 km the model of 15 km will do for 40 px, as in the test of the images' levels.
    /// </summary>
    [Theory]
    [InlineData("native")]
    [InlineData("povray")]
    public void DryRun_SeveralModels_TellsTheCellsThatWouldBeDrawn(string renderer)
    {
        string[] models = ["--ldem", Moon(), "--ldem", Map(), "--renderer", renderer, "--dry-run", "--format", "csv"];
        (string, string) Drawn(params string[] arguments)
        {
            CommandLineRun run = CommandLineRun.Of([.. arguments, .. models]);
            Assert.True(run.ExitCode == 0, run.Error);
            string[][] lines = [.. run.Output.TrimEnd().Split('\n').Select(line => line.Split(','))];
            Assert.Equal(["drawn_cell_0_m", "drawn_cell_1_m"], lines[0][^2..]);
            return (lines[1][^2][..7], lines[1][^1]);
        }

        Assert.Equal(("15161.6", string.Empty), Drawn(View.Split(' '))); // pi x 1737.4 km / 180 / 2
        Assert.Equal(("15161.6", "10000"), Drawn([.. View.Split(' '), "--lod", "off"]));
    }

    /// <summary>
    /// From 3,200 km with 40 px a cell may be 32 km wide: the model of 15 km will do. From 30 km nothing is coarser than it must be.
    /// </summary>
    [Fact]
    public void Run_LevelsOfDetail_DrawWhatTheFrameNeeds()
    {
        string[] models = ["--ldem", Moon(), "--ldem", Map()];
        CommandLineRun far = Draw("far", [.. models, "--lod", "auto"]);
        CommandLineRun near = Near("near", models, "auto");
        CommandLineRun exact = Near("exact", models, "off");

        Assert.True(far.ExitCode + near.ExitCode + exact.ExitCode == 0, far.Error + near.Error + exact.Error);
        Assert.Contains("resolution=\"10000\" drawn=\"no\" unit=\"m/px\"", Meta("far"), StringComparison.Ordinal);
        Assert.DoesNotContain("<Facet part=\"1\"", Meta("far"), StringComparison.Ordinal);
        Assert.Contains("resolution=\"10000\" drawn=\"10000\" unit=\"m/px\"", Meta("near"), StringComparison.Ordinal);
        Assert.Equal(
            File.ReadAllBytes(Path.Combine(_folder["out"], "exact.png")), File.ReadAllBytes(Path.Combine(_folder["out"], "near.png")));
    }

    /// <summary>
    /// The two pieces of 5 m, 500 and 200 m wide, lie 180 km from the pole in cells of 7.6 km; a synthetic map lies between.
    /// </summary>
    [RequiresFact(Part.Ldem4, Part.PolarPieces, Part.GdalLibrary)]
    public void Run_RealPiecesInAModelOfTheWholeMoon_AreDrawnAsGroundOfTheirOwn()
    {
        string between = SyntheticModels.MakePolar(_folder["model"], 2000);
        string[] models =
        [
            "--ldem", TestParts.Ldem4Label!, "--ldem", between,
            "--ldem", TestParts.PolarPiece("NPB")!, "--ldem", TestParts.PolarPiece("NPC")!,
        ];
        CommandLineRun run = CommandLineRun.Of(
            ["--renderer", "native", .. models, "--position=-84.1525,90.3228,2000", "--time", "2026-01-10T00:00:00Z", "--ignore-sun",
             "--surface", "terrain", "--gridH", "4", "--gridV", "4", "--width", "40", "--height", "40", "--fov", "40", "--batch",
             "--output-dir", _folder["out"], "--output-name", "piece"]);

        Assert.True(run.ExitCode == 0, run.Error);
        string xml = Meta("piece");
        Assert.Contains("product=\"NPB_final_adj_5mpp_surf_piece_1km_2_12\"", xml, StringComparison.Ordinal);
        Assert.Contains("<Facet part=\"2\"", xml, StringComparison.Ordinal); // NPB, the smaller one, is before NPC
    }

    /// <summary>A tile of SLDEM2015 and one of Kaguya's Terrain Camera in it: alone their ground is that over LDEM_4.</summary>
    [RequiresFact(Part.Field, Part.Ldem4, Part.GdalLibrary)]
    public void Run_TilesWithoutAModelOfTheMoon_AreDrawnAsInOne()
    {
        string[] tiles =
        [
            "--ldem", Path.Combine(TestParts.Field!, "29", "SLDEM2015_4_00N_30N_000_045_FLOAT.LBL"),
            "--ldem", Path.Combine(TestParts.Field!, "29", "DTM_MAPs02_N12E018N09E021SC.lbl"),
        ];
        double[] HeightsOf(string name, params string[] more)
        {
            CommandLineRun run = CommandLineRun.Of(
                ["--renderer", "native", .. tiles, .. more, "--position=10.5,19.5,60000", "--time", "2026-01-08T00:00:00Z", "--ignore-sun",
                 "--width", "80", "--height", "80", "--fov", "60", "--lod", "off", "--layers", "height", "--layers-format", "npy",
                 "--batch", "--output-dir", _folder["out"], "--output-name", name]);
            Assert.True(run.ExitCode == 0, run.Error);
            Assert.Equal(more.Length == 0, run.Error.Contains("around the maps there is no ground", StringComparison.Ordinal));
            return [.. Npy(name + ".height").Select(value => BitConverter.ToDouble(value))];
        }

        double[] alone = HeightsOf("alone");
        double[] around = HeightsOf("around", "--ldem", TestParts.Ldem4Label!);
        Assert.All(alone.Zip(around), pair => Assert.Equal(pair.Second, pair.First, 1e-6));
        Assert.DoesNotContain("misfitMean=\"0\"", Meta("alone"), StringComparison.Ordinal);
    }

    /// <summary>Of a file with two bands the first one is drawn, and a note says so.</summary>
    [RequiresFact(Part.Gdal, Part.PolarPieces, Part.GdalLibrary)]
    public void Run_SecondBand_IsNoted()
    {
        ChildRun.Of(
            "gdal_translate", ["-q", "-b", "1", "-b", "1", TestParts.PolarPiece("NPC")!, _folder["two.tif"]], _folder.Path).Succeeded();
        string NotesOf(string path)
        {
            CommandLineRun run = CommandLineRun.Of(
                ["--renderer", "native", "--ldem", path, "--position=-84.8,126,9000", "--time", "61060", "--width", "20", "--height", "20",
                 "--batch", "--output-dir", _folder["out"]]);
            Assert.True(run.ExitCode == 0, run.Error);
            return run.Error;
        }

        Assert.Contains("It has 2 bands; heights are those of the first one.", NotesOf(_folder["two.tif"]), StringComparison.Ordinal);
        Assert.DoesNotContain(" bands; ", NotesOf(TestParts.PolarPiece("NPC")!), StringComparison.Ordinal);
    }

    /// <summary>
    /// A real map of 5 m that lies 47 m below LDEM_4 in the mean, under low Suns: in LDEM_4 its ground is as lit as alone.
    /// </summary>
    [RequiresTheory(Part.Ldem4, Part.PolarPieces, Part.GdalLibrary)]
    [InlineData("61060.06223092263", 5.3)]
    [InlineData("61056.72444129065", 2.4)]
    public void Run_RealMapInLowerGround_IsAsLitAsAlone(string time, double sun)
    {
        string[] moon = ["--ldem", TestParts.Ldem4Label!];
        string[] map = ["--ldem", TestParts.PolarPiece("NPC")!];
        double alone = LitShare("alone", time, map);

        Assert.InRange(LitShare("nested", time, [.. moon, .. map]), alone - 1.0, alone + 1.0);
        Assert.Contains("misfitMean=\"-4", Meta("nested"), StringComparison.Ordinal);
        Assert.InRange(90.0 - Npy("alone.sphere-incidence").Average(value => BitConverter.ToDouble(value)), sun - 0.05, sun + 0.05);
    }

    /// <summary>
    /// Moved up, the map lies higher by as much, and as the layer says; the meta file tells it. Shifted, it is seen beside its place.
    /// </summary>
    [RequiresFact(Part.Ldem4, Part.PolarPieces, Part.GdalLibrary)]
    public void Run_MovedMap_LiesWhereItIsSaid()
    {
        string map = TestParts.PolarPiece("NPC")!;
        double[] HeightsOf(string name, string options)
        {
            CommandLineRun run = CommandLineRun.Of(
                ["--renderer", "native", "--ldem", TestParts.Ldem4Label!, "--ldem", map + options, "--position=-84.809,125.96,20000",
                 "--time", "61060", "--ignore-sun", "--lod", "off", "--width", "80", "--height", "80", "--fov", "3.4", "--layers",
                 "height,source", "--layers-format", "npy", "--batch", "--output-dir", _folder["out"], "--output-name", name]);
            Assert.True(run.ExitCode == 0, run.Error);
            (int, int)[] sources =
                [.. Npy(name + ".source").Select(value => (BitConverter.ToInt32(value), BitConverter.ToInt32(value, 4)))];
            Assert.InRange(sources.Count(source => source == (1, 1)), 6300, 6400);
            Assert.All(sources, source => Assert.Contains(source, ((int, int)[])[(1, 1), (1, 3)])); // measured, or a seam in a corner
            return [.. Npy(name + ".height").Select(value => BitConverter.ToDouble(value))];
        }

        double[] before = HeightsOf("before", string.Empty);
        double[] raised = HeightsOf("raised", ",offset=-37.5");
        double[] met = HeightsOf("met", ",offset=auto");
        double[] shifted = HeightsOf("shifted", ",shift=-100,0");

        Assert.InRange(raised.Average() - before.Average(), -38.5, -36.5); // rays through pixels meet other ground
        Assert.InRange(met.Average() - before.Average(), 46.0, 48.0);
        Assert.Contains(" offset=\"-37.5\" shiftEast=\"0\"", Meta("raised"), StringComparison.Ordinal);
        Assert.Matches(" offset=\"4[67]\\.\\d+\" .* misfitMean=\"-?0\\.00\"", Meta("met"));

        // The camera looks down with north up: 100 m are 6.7 pixels to the left.
        double best = Enumerable.Range(-12, 25).MinBy(right => Enumerable.Range(15, 50).Sum(x => Enumerable.Range(0, 80).Sum(
            y => Math.Abs(shifted[(80 * y) + x] - before[(80 * y) + x + right]))));
        Assert.InRange(best, 6, 7);
    }

    /// <summary>%: pixels on which the Sun's centre shines, of an image of the map's middle, 300 m and more from its sides.</summary>
    private double LitShare(string name, string time, string[] models)
    {
        CommandLineRun run = CommandLineRun.Of(
            ["--renderer", "native", .. models, "--position=-84.809,125.96,20000", "--time", time, "--lod", "off", "--width", "80",
             "--height", "80", "--fov", "3.4", "--layers", "mask,sphere-incidence", "--layers-format", "npy", "--batch", "--output-dir",
             _folder["out"], "--output-name", name]);
        Assert.True(run.ExitCode == 0, run.Error);
        return 100.0 * Npy(name + ".mask").Count(value => value[0] == 1) / (80 * 80);
    }

    /// <summary>The values of a file of 80 x 80 pixels.</summary>
    private List<byte[]> Npy(string name)
    {
        byte[] file = File.ReadAllBytes(Path.Combine(_folder["out"], name + ".npy"));
        int header = 10 + BitConverter.ToUInt16(file, 8);
        return [.. file.Skip(header).Chunk((file.Length - header) / (80 * 80))];
    }

    private CommandLineRun Draw(string name, params string[] options) => CommandLineRun.Of(
        [.. View.Split(' '), "--renderer", "native", "--surface", "terrain", "--gridH", "2", "--gridV", "2", .. options, "--output-dir",
            _folder["out"], "--output-name", name]);

    private CommandLineRun Near(string name, string[] models, string levels) => CommandLineRun.Of(
        ["--renderer", "native", .. models, "--lod", levels, "--position=-81,20,30000", "--time", "2026-01-10T00:00:00Z", "--ignore-sun",
            "--batch", "--width", "40", "--height", "40", "--fov", "60", "--output-dir", _folder["out"], "--output-name", name]);

    private string Meta(string name) => File.ReadAllText(Path.Combine(_folder["out"], $"{name}.xml"));

    private string Moon() => SyntheticModels.Make(_folder["model"], "--res", "2");

    private string Map() => SyntheticModels.MakePolar(_folder["model"], 10000);
}
