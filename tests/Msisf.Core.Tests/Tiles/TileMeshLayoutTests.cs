using Msisf.Core.Tiles;
using Xunit;

namespace Msisf.Core.Tests.Tiles;

public class TileMeshLayoutTests
{
    [Fact]
    public void For_InnerTile_EndsOneSampleIntoTheNeighbours()
    {
        TileMeshLayout layout = TileMeshLayout.For(new TileId(0, 355), pixelsPerDegree: 4);

        Assert.Equal((340, 21, 1420, 21), (layout.FirstLine, layout.Lines, layout.FirstSample, layout.Samples));
        Assert.Equal((441, 800), (layout.VertexCount, layout.FaceCount));
    }

    [Theory]
    [InlineData(85, 0, 21, 442, 820)]
    [InlineData(-90, 700, 20, 421, 780)]
    public void For_PolarTile_EndsInAPole(int south, int firstLine, int lines, int vertices, int faces)
    {
        TileMeshLayout layout = TileMeshLayout.For(new TileId(south, 10), pixelsPerDegree: 4);

        Assert.Equal((firstLine, lines), (layout.FirstLine, layout.Lines));
        Assert.Equal((vertices, faces), (layout.VertexCount, layout.FaceCount));
        Assert.Equal((south > 0, south < 0), (layout.HasNorthPole, layout.HasSouthPole));
    }

    [Fact]
    public void For_Margin_AddsRingsAndCrossesTheMeridian()
    {
        TileMeshLayout layout = TileMeshLayout.For(new TileId(0, 0), pixelsPerDegree: 4, marginSamples: 2);

        Assert.Equal((338, 25, 1438, 25), (layout.FirstLine, layout.Lines, layout.FirstSample, layout.Samples));
    }

    [Theory]
    [InlineData(85, 0, 23)]
    [InlineData(-90, 698, 22)]
    public void For_MarginAtAPole_IsClipped(int south, int firstLine, int lines)
    {
        TileMeshLayout layout = TileMeshLayout.For(new TileId(south, 0), pixelsPerDegree: 4, marginSamples: 2);

        Assert.Equal((firstLine, lines), (layout.FirstLine, layout.Lines));
        Assert.True(layout.HasNorthPole || layout.HasSouthPole);
    }

    [Fact]
    public void CreateFaces_InnerTile_RunsTheDiagonalFromNorthWestToSouthEast()
    {
        int[] faces = TileMeshLayout.For(new TileId(0, 0), pixelsPerDegree: 1).CreateFaces();

        Assert.Equal([0, 6, 7, 0, 7, 1], faces[..6]);
        Assert.Equal([28, 34, 35, 28, 35, 29], faces[^6..]);
    }

    [Fact]
    public void CreateFaces_NorthPole_BeginsWithTheFan()
    {
        int[] faces = TileMeshLayout.For(new TileId(85, 0), pixelsPerDegree: 1).CreateFaces();

        Assert.Equal([0, 1, 2, 0, 2, 3], faces[..6]);
        Assert.Equal([0, 5, 6, 1, 7, 8, 1, 8, 2], faces[12..21]);
    }

    [Fact]
    public void CreateFaces_SouthPole_EndsWithTheFan()
    {
        int[] faces = TileMeshLayout.For(new TileId(-90, 0), pixelsPerDegree: 1).CreateFaces();

        Assert.Equal([28, 30, 29], faces[^3..]);
        Assert.Equal([24, 30, 25], faces[^15..^12]);
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(4, -1)]
    [InlineData(4, 5)]
    public void For_ImpossibleNumbers_Throws(int pixelsPerDegree, int marginSamples) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => TileMeshLayout.For(new TileId(0, 0), pixelsPerDegree, marginSamples));
}
