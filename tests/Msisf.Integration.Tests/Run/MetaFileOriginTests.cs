using System.Globalization;
using System.Xml.Linq;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>What the meta file of a run says of the elevation model, the levels drawn and the height of the camera.</summary>
public sealed class MetaFileOriginTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>The middle pixel of a camera that looks down lies below it: its range is the height over the terrain.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_LookingDown_IsAsHighOverTheTerrainAsTheMiddlePixelIsAway()
    {
        XElement root = Render("{55289,1.8E6,0,0,0,0,0,1}", "--fov", "10", "--surface", "terrain", "--grid", "32");

        XElement middle = root.Descendants("Pixel").Single(pixel => ((int)pixel.Attribute("h")!, (int)pixel.Attribute("v")!) == (32, 32));
        double height = Number(root.Descendants("HeightOverTerrain").Single());
        Assert.Equal(Number(middle.Element("Range")!), height, Tolerances.VertexLattice);
        Assert.Equal(1.8e6 - 1_737_150.0, Number(root.Descendants("FlightAltitude").Single()), 1e-6);
        Assert.InRange(Math.Abs(height - 62_850.0), 100.0, 10_000.0);
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_FarCamera_NamesTheModelsResolutionAndTheLevelDrawn()
    {
        XElement root = Render("{55289,4E7,0,0,0,0,0,1}", "--fov", "6");

        XElement model = root.Descendants("ElevationModel").Single();
        Assert.Equal("4", root.Descendants("SurfaceResolution").Single().Value);
        Assert.Equal(("LDEM_4", "no"), (model.Attribute("product")!.Value, model.Attribute("synthetic")!.Value));
        Assert.Equal(model.Attribute("drawnFinest")!.Value, model.Attribute("drawnCoarsest")!.Value);
        Assert.Contains(model.Attribute("drawnFinest")!.Value, (string[])["1", "2"]);
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_Inputs_AreTheModelsFilesAndTheKernels()
    {
        XElement root = Render("{55289,1.8E6,0,0,0,0,0,1}");

        // sha256sum of LDEM_4.IMG V3.0 as NASA's PDS has it.
        XElement[] inputs = [.. root.Descendants("Input")];
        Assert.Equal(
            ["elevation-label", "elevation-image", "kernel", "kernel", "kernel", "kernel", "kernel"],
            inputs.Select(input => input.Attribute("kind")!.Value));
        Assert.Equal(
            ("LDEM_4.IMG", "2073600", "972d66d7f330abca62abc21aae270661516c00dd1a881ec102b94df9563656b5"),
            (inputs[1].Attribute("name")!.Value, inputs[1].Attribute("bytes")!.Value, inputs[1].Attribute("sha256")!.Value));
        Assert.DoesNotContain(_folder.Path, root.ToString(), StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_IgnoreSun_NamesNoKernel() => Assert.Equal(
        ["elevation-label", "elevation-image"],
        Render("{55289,1.8E6,0,0,0,0,0,1}", "--ignore-sun").Descendants("Input").Select(input => input.Attribute("kind")!.Value));

    private static double Number(XElement element) => double.Parse(element.Value, CultureInfo.InvariantCulture);

    private XElement Render(string state, params string[] more)
    {
        CommandLineRun run = CommandLineRun.Of(
        [
            "--fixed-state", state, "--renderer", "native", "--reflectance", "lambert", "--width", "63", "--height", "63",
            "--ldem", TestParts.Ldem4Label!,
            "--output-dir", _folder["out"], "--output-name", "view", "--batch",
            .. more.Contains("--ignore-sun") ? [] : (string[])["--ephemeris", "builtin"], .. more,
        ]);
        Assert.True(run.ExitCode == 0, run.Error);
        return XDocument.Load(_folder["out/view.xml"]).Root!;
    }
}
