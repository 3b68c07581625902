using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Surface;

public sealed class BlockVerticesTests
{
    private static readonly Vector3D Camera = new(1_234_567.89, -987_654.321, 1_500_000.1);

    /// <summary>Poles, prime meridian, blocks cut short at 1 and 2 px/deg, and blocks in the middle.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(4)]
    [InlineData(64)]
    public void Load_AnyBlock_GivesTheVerticesOfThePatterns(int pixelsPerDegree)
    {
        IGlobalGrid grid = FunctionGrid.Hilly(pixelsPerDegree);
        SurfaceModel surface = new(grid);
        GridDirections directions = new(pixelsPerDegree);
        BlockVertices vertices = new();
        int rows = CellBlock.RowsOf(surface.Parts[0].Mesh);
        int columns = CellBlock.ColumnsOf(surface.Parts[0].Mesh);
        foreach (int row in new[] { 0, rows / 3, rows - 1 })
        {
            foreach (int column in new[] { 0, columns / 2, columns - 1 })
            {
                CellBlock block = new(row, column);
                vertices.Load(surface, block, Camera);
                CellRange cells = block.Cells(surface.Parts[0].Mesh);
                double[] radii = new double[vertices.Samples];
                for (int i = 0; i < vertices.Lines; i++)
                {
                    int line = cells.FirstLine + i;
                    surface.Parts[0].Mesh.ReadRadii(line, cells.FirstSample, radii);
                    for (int j = 0; j < vertices.Samples; j++)
                    {
                        int sample = (cells.FirstSample + j) % surface.Parts[0].Mesh.Samples;
                        SineCosine latitude =
                            line < 0 ? new(1.0, 0.0) : line == surface.Parts[0].Mesh.Lines ? new(-1.0, 0.0) : directions.Latitude(line);
                        Vector3D expected =
                            LatticePoint.Nearest(radii[j], latitude, directions.Longitude(sample)).PositionBodyFixed - Camera;
                        Assert.Equal(expected, vertices[i, j]);
                    }
                }
            }
        }
    }

    /// <summary>What a wider block has left behind the vertices of a line is none of them.</summary>
    [Fact]
    public void MinZ_AfterAWiderBlock_IsThatOfTheVertices()
    {
        SurfaceModel surface = new(FunctionGrid.Hilly(1));
        BlockVertices vertices = new();
        vertices.Load(surface, new CellBlock(CellBlock.RowsOf(surface.Parts[0].Mesh) - 1, 0), default);
        double southernmost = vertices.MinZ();

        vertices.Load(surface, new CellBlock(0, CellBlock.ColumnsOf(surface.Parts[0].Mesh) - 1), default);

        Assert.Equal(9, vertices.Samples);
        Assert.InRange(southernmost, -1.75e6, -1.7e6); // m: the south pole
        double expected = Enumerable.Range(0, vertices.Lines)
            .SelectMany(line => Enumerable.Range(0, vertices.Samples).Select(sample => vertices[line, sample].Z)).Min();
        Assert.Equal(expected, vertices.MinZ());
        Assert.True(expected > 0.0, "The block is beside the north pole.");
    }

    [Fact]
    public void Cells_OfAllBlocks_CoverEachCellOnce()
    {
        SurfaceModel surface = new(FunctionGrid.Hilly(2));
        int cells = 0;
        for (int row = 0; row < CellBlock.RowsOf(surface.Parts[0].Mesh); row++)
        {
            for (int column = 0; column < CellBlock.ColumnsOf(surface.Parts[0].Mesh); column++)
            {
                CellRange range = new CellBlock(row, column).Cells(surface.Parts[0].Mesh);
                cells += (range.EndLine - range.FirstLine) * (range.EndSample - range.FirstSample);
            }
        }

        Assert.Equal((surface.Parts[0].Mesh.Lines + 1) * surface.Parts[0].Mesh.Samples, cells);
    }
}
