using System.Text;
using System.Xml.Linq;
using Msisf.Adapters.Metadata;
using Msisf.Core.Camera;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.TestSupport;
using Xunit;
using static Msisf.Adapters.Tests.Metadata.MetadataXmlWriterTests;

namespace Msisf.Adapters.Tests.Metadata;

/// <summary>What a frame's meta file says of pixels that show terrain.</summary>
public class MetadataXmlTerrainTests
{
    [Theory]
    [InlineData(RendererKind.PovRay, "povray")]
    [InlineData(RendererKind.Native, "native")]
    public void Write_Terrain_NamesSurfaceRendererAndVersionAndIsValid(RendererKind renderer, string name)
    {
        FrameMetadata frame = Frame() with { Renderer = renderer };

        XDocument document = MetaFileXml.Parse(TerrainText(frame, spacing: 50));

        XElement surface = document.Root!.Element("GeneralInformation")!.Element("PixelSurface")!;
        Assert.Equal("CommandLine", surface.ElementsBeforeSelf().Last().Name.LocalName);
        Assert.Equal(
            [("type", "terrain"), ("renderer", name), ("formatVersion", "3")],
            surface.Attributes().Select(attribute => (attribute.Name.LocalName, attribute.Value)));
        XElement[] pixels = [.. document.Descendants("Pixel")];
        Assert.InRange(pixels.Length, 363 - 20, 363 + 20); // by numpy 363 on the sphere; hills move the limb
        Assert.All(pixels, pixel => Assert.Equal(
            ["Height", "Position", "Range", "Normal", "IncidenceAngle", "EmissionAngle", "PhaseAngle", "Illumination", "Facet"],
            pixel.Elements().Skip(2).Select(element => element.Name.LocalName)));
    }

    [Fact]
    public void Write_TerrainWithoutItsElements_DiffersFromTheSphereOnlyInTheVersion()
    {
        // The same points: all that is added is added in lines of its own.
        FrameMetadata frame = Frame() with { Renderer = RendererKind.Native };
        string[] added =
        [
            "PixelSurface", "Height ", "Position", "Range", "Normal", "IncidenceAngle", "EmissionAngle", "PhaseAngle", "Illumination ",
            "Facet"
        ];

        IEnumerable<string> terrain = TerrainText(frame, spacing: 50).Split('\n')
            .Where(line => !added.Any(name => line.TrimStart().StartsWith($"<{name}", StringComparison.Ordinal)));

        Assert.Equal(Text(frame, spacing: 50).Split('\n'), terrain);
    }

    [Fact]
    public void Write_TerrainLargeEnoughForThreads_KeepsRecordsAndOrder()
    {
        FrameMetadata frame = Frame();
        XElement[] pixels = [.. MetaFileXml.Parse(TerrainText(frame, spacing: 14)).Descendants("Pixel")];

        PixelRecord[] records = [.. TerrainSampler(frame, spacing: 14).Sample()];

        Assert.Equal(
            records.Select(record => (record.H, record.V)),
            pixels.Select(pixel => ((int)pixel.Attribute("h")!, (int)pixel.Attribute("v")!)));
        Assert.Equal(
            records.Select(record => LongE.ToText(record.Terrain!.Value.Range)), pixels.Select(pixel => pixel.Element("Range")!.Value));
    }

    private static PixelSampler TerrainSampler(FrameMetadata frame, int spacing) => new(
        new PixelGrid(frame.Camera.Width, frame.Camera.Height, spacing, spacing),
        FunctionTruth.OfSphere(frame.Camera, frame.SunPositionBodyFixed),
        4);

    internal static string TerrainText(FrameMetadata frame, int spacing)
    {
        using MemoryStream stream = new();
        MetadataXmlWriter.Write(stream, frame, TerrainSampler(frame, spacing));
        return Encoding.UTF8.GetString(stream.ToArray());
    }
}
