using System.Globalization;
using System.Text;
using System.Xml;
using System.Xml.Linq;
using System.Xml.Schema;
using Msisf.Adapters.Metadata;
using Msisf.Core.Camera;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Time;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Metadata;

public class MetadataXmlWriterTests
{
    /// <summary>
    /// Thesis section 9.2 with the exact angles (docs/deviations.md, row 10); the last digits of the pixels are those of
    /// tests/reference/illumination.py, rounded.
    /// </summary>
    private const string PublishedHead = """
        <?xml version="1.0" encoding="UTF-8" standalone="no" ?>
        <!DOCTYPE MSISRendering [grammar]>
        <MSISRendering>
          <GeneralInformation>
            <SimulationTime>
              <MJD>+5.528900000000000E+004</MJD>
              <UTC>2010-04-03T00:00:00Z</UTC>
            </SimulationTime>
            <CameraPosition unit="m">
              <Vector3D x="+2.000000000000000E+006" y="+2.000000000000000E+006" z="+0.000000000000000E+000" />
            </CameraPosition>
            <CameraOrientation>
              <Quaternion r="+8.923991008325228E-001" x="-2.391176183943345E-001" y="+9.904576054128762E-002" z="+3.696438106143861E-001" />
            </CameraOrientation>
            <SunPosition unit="m">
              <Vector3D x="+1.074955473280880E+011" y="-1.042430734878980E+011" z="+4.036164305561260E+009" />
            </SunPosition>
            <FlightAltitude unit="m">+1.091277124746190E+006</FlightAltitude>
            <SurfaceResolution unit="px/deg">64</SurfaceResolution>
            <FOV unit="deg">40</FOV>
            <MSISVersion>1.0.0</MSISVersion>
            <CommandLine>--fixed-state {55289,2E6} -r 64</CommandLine>
            <FormatVersion>3</FormatVersion>
            <HeightOverTerrain unit="m">+1.092583250000000E+006</HeightOverTerrain>
            <ElevationModel product="LDEM_64" synthetic="no" drawnFinest="16" drawnCoarsest="2" unit="px/deg" />
            <Camera width="1024" height="1024">
              <K unit="px">
                +1.406708438760767E+003 +0.000000000000000E+000 +5.115000000000000E+002
                +0.000000000000000E+000 +1.406708438760767E+003 +5.115000000000000E+002
                +0.000000000000000E+000 +0.000000000000000E+000 +1.000000000000000E+000
              </K>
              <R>
        """;

    private const string PublishedInputs = """
            </Camera>
            <Input kind="elevation-label" name="LDEM_64.LBL" bytes="5107" sha256="0123" />
            <Input kind="elevation-image" name="LDEM_64.IMG" bytes="530841600" sha256="4567" />
            <Input kind="kernel" name="&quot;a&quot; &amp; &lt;b&gt;.tls" bytes="7" sha256="89ab" />
          </GeneralInformation>
          <PixelInformation>
            <Pixel h="450" v="100">
              <SelenographicCoordinates lat="
        """;

    /// <summary>px: latitude and longitude have 16 digits, so do K, R and t: 1e-9 m on the ground, some 1e-10 m of t a pixel.</summary>
    private const double PixelError = 1e-9;

    [Fact]
    public void Write_PublishedExample_HasItsTextAndNumbers()
    {
        string xml = Text(Frame(), spacing: 50);

        int grammar = xml.IndexOf(" [\n", StringComparison.Ordinal) + 3;
        int end = xml.IndexOf("\n]>", StringComparison.Ordinal);
        Assert.Equal(Declarations(), xml[grammar..end].Split('\n'));
        Assert.StartsWith(PublishedHead, $"{xml[..(grammar - 3)]} [grammar]>{xml[(end + 3)..]}", StringComparison.Ordinal);
        Assert.Contains(PublishedInputs, xml, StringComparison.Ordinal);
        Assert.EndsWith("    </Pixel>\n  </PixelInformation>\n</MSISRendering>\n", xml, StringComparison.Ordinal);
        XElement first = MetaFileXml.Parse(xml).Descendants("Pixel").First();
        XElement coordinates = first.Element("SelenographicCoordinates")!;
        Assert.InRange(
            Number(coordinates.Attribute("lat")!.Value), 44.58440049692400 - Rounding.OfChains, 44.58440049692400 + Rounding.OfChains);
        Assert.InRange(
            Number(coordinates.Attribute("lon")!.Value), 56.79090635326980 - Rounding.OfChains, 56.79090635326980 + Rounding.OfChains);
        Assert.Equal("deg", coordinates.Attribute("units")!.Value);
        XElement direction = first.Element("IlluminationDirection")!;
        Assert.InRange(Number(direction.Value), 280.850536814846401 - Rounding.OfPlaces, 280.850536814846401 + Rounding.OfPlaces);
        Assert.Equal("deg", direction.Attribute("unit")!.Value);
        Assert.Equal("yes", direction.Attribute("defined")!.Value); // the DTD's default
    }

    /// <summary>The lines of lib/MSISRendering.dtd without comments, and without what only truth for navigation and scans need.</summary>
    private static string[] Declarations()
    {
        string text = File.ReadAllText(Path.Combine(TestParts.RepositoryRoot, "lib", "MSISRendering.dtd"));
        IEnumerable<string> parts = text.Split("<!--").Select(part => part[(part.IndexOf("-->", StringComparison.Ordinal) is var at and >= 0
            ? at + 3
            : 0)..]);
        return [.. string.Concat(parts).Split('\n', StringSplitOptions.RemoveEmptyEntries)
            .TakeWhile(line => !line.StartsWith("<!ELEMENT CraterInformation ", StringComparison.Ordinal))
            .Select(line => line
                .Replace(
                    ",CraterInformation?,LandmarkInformation?,StarInformation?,SkyBodyInformation?", string.Empty, StringComparison.Ordinal)
                .Replace("Input+,Scan?,Rig?", "Input+", StringComparison.Ordinal))];
    }

    /// <summary>K, R and t of the file lead from each pixel's coordinates in the file back to the pixel.</summary>
    [Fact]
    public void Write_Camera_ProjectsEachPixelOntoItself()
    {
        XDocument document = MetaFileXml.Parse(Text(Frame(), spacing: 14));
        XElement camera = document.Descendants("Camera").Single();
        double[] k = Numbers(camera.Element("K")!);
        double[] r = Numbers(camera.Element("R")!);
        double[] t = Numbers(camera.Element("t")!);
        XElement[] pixels = [.. document.Descendants("Pixel")];

        Assert.Equal((9, 9, 3), (k.Length, r.Length, t.Length));
        Assert.Equal(4720, pixels.Length); // of the 73 x 73, by numpy: those whose rays meet the sphere
        Assert.All(pixels, pixel =>
        {
            double latitude = Number(pixel.Element("SelenographicCoordinates")!.Attribute("lat")!.Value) * Math.PI / 180.0;
            double longitude = Number(pixel.Element("SelenographicCoordinates")!.Attribute("lon")!.Value) * Math.PI / 180.0;
            double[] point =
            [
                1_737_400.0 * Math.Cos(latitude) * Math.Cos(longitude),
                1_737_400.0 * Math.Cos(latitude) * Math.Sin(longitude),
                1_737_400.0 * Math.Sin(latitude),
            ];
            double[] seen = [.. Enumerable.Range(0, 3).Select(
                row => (r[3 * row] * point[0]) + (r[(3 * row) + 1] * point[1]) + (r[(3 * row) + 2] * point[2]) + t[row])];
            Assert.Equal((int)pixel.Attribute("h")! - 1, ((k[0] * seen[0]) + (k[2] * seen[2])) / seen[2], PixelError);
            Assert.Equal((int)pixel.Attribute("v")! - 1, ((k[4] * seen[1]) + (k[5] * seen[2])) / seen[2], PixelError);
        });
    }

    [Theory]
    [InlineData(false, "CommandLine")] // version 1
    [InlineData(true, "PixelSurface")] // version 2
    public void Dtd_FileOfAnEarlierVersion_IsValidAsItWas(bool isTerrain, string last)
    {
        string xml = isTerrain ? MetadataXmlTerrainTests.TerrainText(Frame(), spacing: 100) : Text(Frame(), spacing: 100);
        int first = xml.IndexOf("    <FormatVersion>", StringComparison.Ordinal);
        int end = xml.IndexOf("  </GeneralInformation>", StringComparison.Ordinal);

        XElement general = MetaFileXml.Parse(xml.Remove(first, end - first)).Root!.Element("GeneralInformation")!;

        Assert.Equal(last, general.Elements().Last().Name.LocalName);
    }

    [Theory]
    [InlineData("<FormatVersion>3</FormatVersion>", "")]
    [InlineData("synthetic=\"no\"", "synthetic=\"maybe\"")]
    [InlineData(" sha256=", " md5=")]
    [InlineData("</R>", "</R><R></R>")]
    public void Dtd_Version3WithAnErrorInIt_IsInvalid(string text, string wrong)
    {
        string xml = Text(Frame(), spacing: 100);
        Assert.Contains(text, xml, StringComparison.Ordinal);

        Assert.ThrowsAny<XmlSchemaException>(() => MetaFileXml.Parse(xml.Replace(text, wrong, StringComparison.Ordinal)));
    }

    [Fact]
    public void Write_Twice_GivesTheSameBytesWithoutBomOrCarriageReturn()
    {
        byte[] first = Bytes(Frame(), spacing: 14);

        Assert.Equal(first, Bytes(Frame(), spacing: 14));
        Assert.Equal((byte)'<', first[0]);
        Assert.DoesNotContain((byte)'\r', first);
    }

    [Fact]
    public void Write_GridLargeEnoughForThreads_KeepsTheOrderOfTheSampler()
    {
        FrameMetadata frame = Frame();
        PixelSampler sampler = Sampler(frame, spacing: 14);

        (int, int)[] written =
            [.. MetaFileXml.Parse(Text(frame, spacing: 14)).Descendants("Pixel").Select(
                pixel => ((int)pixel.Attribute("h")!, (int)pixel.Attribute("v")!))];

        Assert.True(sampler.Grid.Rows * sampler.Grid.Columns > 4096); // else one thread writes all
        Assert.Equal(sampler.Sample().Select(record => (record.H, record.V)), written);
    }

    [Fact]
    public void Write_UndefinedDirection_SaysSoAndHasNoNumber()
    {
        PinholeCamera camera = new(new Vector3D(4e6, 0.0, 0.0), UnitQuaternion.Identity, 0.1, 1, 1);
        FrameMetadata belowTheSun = Frame() with { Camera = camera, SunPositionBodyFixed = new Vector3D(1e11, 0.0, 0.0) };

        string xml = Text(belowTheSun, spacing: 1);

        Assert.Contains("""
                <Pixel h="1" v="1">
                  <SelenographicCoordinates lat="+0.000000000000000E+000" lon="+0.000000000000000E+000" units="deg" />
                  <IlluminationDirection unit="deg" defined="no" />
                </Pixel>
            """, xml, StringComparison.Ordinal);
        Assert.DoesNotContain("NaN", xml, StringComparison.Ordinal);
    }

    [Fact]
    public void Write_ImageOfSpace_HasNoPixel()
    {
        PinholeCamera away = new(new Vector3D(4e6, 0.0, 0.0), UnitQuaternion.FromAxisAngle(Vector3D.UnitZ, Math.PI), 0.7, 64, 64);

        string xml = Text(Frame() with { Camera = away }, spacing: 1);

        Assert.EndsWith("  <PixelInformation>\n  </PixelInformation>\n</MSISRendering>\n", xml, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("-o \"a & b\" <in> ]]>", "-o \"a & b\" <in> ]]>")]
    [InlineData("Mond\u00FCberflug \U0001F311", "Mond\u00FCberflug \U0001F311")]
    [InlineData("tab\tline\nreturn\r", "tab\tline\nreturn\r")]
    [InlineData("bell\u0007 escape\u001B", "bell\u2407 escape\u241B")]
    public void Write_AnyCommandLine_ComesBackFromAParser(string commandLine, string expected)
    {
        string xml = Text(Frame() with { CommandLine = commandLine }, spacing: 1000);

        Assert.Equal(expected, MetaFileXml.Parse(xml).Descendants("CommandLine").Single().Value);
        Assert.Equal(1, xml.Split("<CommandLine>")[1].Split('\n')[0].Split("</CommandLine>").Length - 1);
    }

    [Fact]
    public void Write_CommandLineThatIsNotUnicode_ShowsWhereItWas()
    {
        // Not a theory: an attribute's text is UTF-8 and can't hold half a pair.
        string xml = Text(Frame() with { CommandLine = "half \uD83C pair \uFFFE" }, spacing: 1000);

        Assert.Equal("half \uFFFD pair \uFFFD", MetaFileXml.Parse(xml).Descendants("CommandLine").Single().Value);
    }

    [Fact]
    public void Write_Cancelled_Stops()
    {
        FrameMetadata frame = Frame();
        CancellationToken cancelled = new(canceled: true);

        Assert.ThrowsAny<OperationCanceledException>(
            () => MetadataXmlWriter.Write(Stream.Null, frame, Sampler(frame, spacing: 1), cancellation: cancelled));
    }

    internal static FrameMetadata Frame()
    {
        UnitQuaternion orientation = UnitQuaternion.FromComponents(
            -2.391176183943345e-001, +9.904576054128762e-002, +3.696438106143861e-001, +8.923991008325228e-001);
        return new FrameMetadata(
            Moments.OfMjd(55289.0),
            new PinholeCamera(new Vector3D(2e6, 2e6, -0.0), orientation, double.DegreesToRadians(40.0), 1024, 1024),
            40.0,
            new Vector3D(+1.074955473280880E+011, -1.042430734878980E+011, +4.036164305561260E+009),
            new DrawnElevation("LDEM_64", IsSynthetic: false, 64, 16, 2),
            1092583.25,
            "1.0.0",
            "--fixed-state {55289,2E6} -r 64",
            RendererKind.PovRay,
            [
                new InputFile(InputKind.ElevationLabel, "LDEM_64.LBL", 5107, "0123"),
                new InputFile(InputKind.ElevationImage, "LDEM_64.IMG", 530841600, "4567"),
                new InputFile(InputKind.Kernel, "\"a\" & <b>.tls", 7, "89ab"),
            ]);
    }

    private static PixelSampler Sampler(FrameMetadata frame, int spacing) =>
        new(
            frame.Camera,
            new PixelGrid(frame.Camera.Width, frame.Camera.Height, spacing, spacing),
            ReferenceSphere.Lola,
            new SceneLight(frame.SunPositionBodyFixed, IsSun: true));

    private static byte[] Bytes(FrameMetadata frame, int spacing)
    {
        using MemoryStream stream = new();
        MetadataXmlWriter.Write(stream, frame, Sampler(frame, spacing));
        return stream.ToArray();
    }

    internal static string Text(FrameMetadata frame, int spacing) => Encoding.UTF8.GetString(Bytes(frame, spacing));

    private static double[] Numbers(XElement element) =>
        [.. element.Value.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries).Select(Number)];

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
