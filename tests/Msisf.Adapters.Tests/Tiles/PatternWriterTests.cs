using System.Globalization;
using System.Text;
using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Tiles;
using Msisf.Core.Surface;
using Msisf.Core.Tiles;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Tiles;

public class PatternWriterTests
{
    // tests/golden/README.md: written by tests/reference/pattern_format.py, which shares no code with the program.
    [RequiresTheory(Part.Ldem4)]
    [InlineData(0, 355)]
    [InlineData(85, 0)]
    [InlineData(-90, 355)]
    public void Write_RealTile_IsTheGoldenFileByteForByte(int south, int west)
    {
        using LdemImage image = LdemImage.Open(LdemLabelReader.ReadFile(TestParts.Ldem4Label!));
        TileMeshLayout layout = TileMeshLayout.For(new TileId(south, west), 4);
        TileMeshBuilder builder = new(image);
        string golden = Path.Combine(
            TestParts.RepositoryRoot, "tests", "golden", "patterns", $"pattern_LDEM_4_{layout.Tile.RangeText}.inc");

        string written = Write(builder.Build(layout, builder.ReadRadii(layout)), PatternFormat.Mesh2);

        Assert.Equal(File.ReadAllText(golden), written);
    }

    [RequiresFact(Part.Ldem4)]
    public void Build_AllTilesOfTheRealMoon_CloseTheSurface()
    {
        using LdemImage image = LdemImage.Open(LdemLabelReader.ReadFile(TestParts.Ldem4Label!));
        TileMeshBuilder builder = new(image);
        ClosedSurface surface = new();
        foreach (TileId tile in TileId.All)
        {
            TileMeshLayout layout = TileMeshLayout.For(tile, 4);
            surface.Add(builder.Build(layout, builder.ReadRadii(layout)));
        }

        Assert.Equal(0, surface.CountOpenEdges());
        Assert.Equal(0, surface.InwardFaces);
        Assert.Equal(2, surface.EulerCharacteristic);
        Assert.Equal((720 * 1440) + 2, surface.Vertices);
        Assert.Equal((2 * 719 * 1440) + (2 * 1440), surface.Faces);
    }

    [Theory]
    [InlineData(PatternFormat.Mesh2, 4)] // fits into the writer's buffer
    [InlineData(PatternFormat.Mesh2, 16)]
    [InlineData(PatternFormat.Mesh, 16)]
    public void Write_AnyFormat_CarriesItsOwnLength(PatternFormat format, int resolution)
    {
        using MemoryStream stream = new();
        stream.Write("before"u8);
        PatternWriter.Write(stream, RoughMesh(resolution), "TEST_GRID", format);
        string text = Encoding.ASCII.GetString(stream.ToArray());

        Assert.Equal(stream.Length, stream.Position);
        Assert.StartsWith("before// msisf-pattern 1 format=", text, StringComparison.Ordinal);
        Assert.Contains(string.Create(CultureInfo.InvariantCulture, $" bytes={text.Length - 6:D12}\n"), text, StringComparison.Ordinal);
        Assert.EndsWith("}\n", text, StringComparison.Ordinal);
    }

    /// <summary>The text of a vertex number is made once for small meshes, and anew each time for large ones.</summary>
    [Theory]
    [InlineData(4, 441)]
    [InlineData(64, 103_041)]
    public void Write_Mesh2_NamesTheVerticesOfEachTriangle(int resolution, int vertices)
    {
        TileMesh mesh = RoughMesh(resolution);
        Assert.Equal(vertices, mesh.VertexCount);

        string text = Write(mesh, PatternFormat.Mesh2);

        int start = text.IndexOf("face_indices{", StringComparison.Ordinal);
        string[] lines = text[start..text.IndexOf('}', start)].Split(",\n");
        Assert.Equal($"face_indices{{{mesh.FaceCount}", lines[0]);
        Assert.Equal(mesh.Faces.Chunk(3).Select(face => $"<{face[0]},{face[1]},{face[2]}>"), lines[1..]);
    }

    [Fact]
    public void Write_Mesh_HasEachVertexInExactKilometres()
    {
        TileMesh mesh = RoughMesh(resolution: 1);
        string[] lines = Write(mesh, PatternFormat.Mesh).Split('\n');

        // A lattice step is 0.0000078125 km: ten decimals hold every vertex exactly.
        LatticePoint[] points = [.. mesh.Faces[..3].Select(mesh.Vertex)];
        string expected = string.Join(
            ", ", points.Select(point => $"<{Kilometres(point.X)}, {Kilometres(point.Y)}, {Kilometres(point.Z)}>"));
        Assert.Equal(["mesh {", "triangle {", expected, "texture { moon }", "}", "triangle {"], lines[1..7]);
        Assert.Equal(3 + (4 * mesh.Layout.FaceCount) + 1, lines.Length);
        Assert.Contains("<-", expected, StringComparison.Ordinal);
    }

    [Fact]
    public void Write_OtherRadii_GivesAnotherHash()
    {
        TileMesh mesh = RoughMesh(resolution: 1);
        double[] changed = [.. mesh.Radii];
        changed[7] = Math.BitIncrement(changed[7]); // moves no vertex on the lattice

        Assert.NotEqual(Write(mesh, PatternFormat.Mesh2), Write(mesh with { Radii = changed }, PatternFormat.Mesh2));
    }

    private static string Kilometres(int steps) => (steps * 0.0000078125m).ToString("F10", CultureInfo.InvariantCulture);

    private static TileMesh RoughMesh(int resolution)
    {
        TileMeshLayout layout = TileMeshLayout.For(new TileId(-35, 140), resolution);
        TileMeshBuilder builder = new(FunctionGrid.Rough(resolution));
        return builder.Build(layout, builder.ReadRadii(layout));
    }

    private static string Write(TileMesh mesh, PatternFormat format)
    {
        using MemoryStream stream = new();
        PatternWriter.Write(stream, mesh, "LDEM_4", format);
        return Encoding.ASCII.GetString(stream.ToArray());
    }
}
