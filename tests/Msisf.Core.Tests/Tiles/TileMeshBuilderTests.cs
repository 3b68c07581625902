using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Tiles;

public class TileMeshBuilderTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void Build_AllTilesOfARoughMoon_CloseTheSurface(int pixelsPerDegree)
    {
        TileMeshBuilder builder = new(FunctionGrid.Rough(pixelsPerDegree));
        ClosedSurface surface = new();
        foreach (TileId tile in TileId.All)
        {
            surface.Add(Build(builder, TileMeshLayout.For(tile, pixelsPerDegree)));
        }

        Assert.Equal(0, surface.CountOpenEdges());
        Assert.Equal(0, surface.InwardFaces);
        Assert.Equal(2, surface.EulerCharacteristic);
        Assert.Equal((180 * 360 * pixelsPerDegree * pixelsPerDegree) + 2, surface.Vertices);
    }

    [Fact]
    public void Build_OneTileLeftOut_LeavesItsBorderOpen()
    {
        TileMeshBuilder builder = new(FunctionGrid.Rough(2));
        ClosedSurface surface = new();
        foreach (TileId tile in TileId.All.Where(tile => tile != new TileId(20, 355)))
        {
            surface.Add(Build(builder, TileMeshLayout.For(tile, 2)));
        }

        Assert.InRange(surface.CountOpenEdges(), 40, int.MaxValue);
    }

    [Fact]
    public void Build_EveryVertex_LiesWithinHalfAStepOfItsSample()
    {
        FunctionGrid grid = FunctionGrid.Rough(4);
        TileMeshBuilder builder = new(grid);
        foreach (TileId tile in new[] { new TileId(0, 0), new TileId(40, 130), new TileId(-65, 355), new TileId(80, 250) })
        {
            TileMeshLayout layout = TileMeshLayout.For(tile, 4, marginSamples: 1);
            TileMesh mesh = Build(builder, layout);
            for (int vertex = 0; vertex < layout.VertexCount; vertex++)
            {
                double latitude = 90.0 - ((layout.FirstLine + (vertex / layout.Samples) + 0.5) / 4.0);
                double longitude = (layout.FirstSample + (vertex % layout.Samples) + 0.5) / 4.0;
                Vector3D expected = mesh.Radii[vertex]
                    * new SelenographicPoint(double.DegreesToRadians(latitude), double.DegreesToRadians(longitude)).ToDirectionBodyFixed();
                Vector3D error = mesh.Vertex(vertex).PositionBodyFixed - expected;

                // Half a step, and a few ulps of 1.7e6 m for this plain computation.
                Assert.InRange(Math.Max(Math.Abs(error.X), Math.Max(Math.Abs(error.Y), Math.Abs(error.Z))), 0.0, (0.5 / 128) + 2e-9);
            }
        }
    }

    [Theory]
    [InlineData(85, 0)]
    [InlineData(-90, 359)]
    public void ReadRadii_PolarTile_GivesThePoleTheMeanOfItsLine(int south, int line)
    {
        FunctionGrid grid = new(2, (i, j) => i == line && j % 2 == 0 ? 1_737_500.0 : 1_737_400.0);
        TileMeshLayout layout = TileMeshLayout.For(new TileId(south, 100), 2);
        TileMeshBuilder builder = new(grid);
        double[] radii = builder.ReadRadii(layout);

        int pole = south > 0 ? 0 : layout.VertexCount - 1;
        Assert.Equal(1_737_450.0, radii[pole]);
        Assert.Equal(new LatticePoint(0, 0, Math.Sign(south) * 1_737_450 * 128), builder.Build(layout, radii).Vertex(pole));
    }

    [Fact]
    public void Build_WidestMargin_KeepsOffsetsBelow24Bits()
    {
        TileMeshBuilder builder = new(new FunctionGrid(1, (_, _) => 1_748_500.0));
        foreach (TileId tile in TileId.All)
        {
            TileMesh mesh = Build(builder, TileMeshLayout.For(tile, 1, marginSamples: 1));
            Assert.InRange(mesh.Offsets.Max(Math.Abs), 0, TileMesh.OffsetLimit - 1);
        }
    }

    [Theory]
    [InlineData(1_900_000.0)]
    [InlineData(double.NaN)]
    [InlineData(-1.0)]
    [InlineData(1e300)]
    public void Build_ImpossibleRadius_NamesLineAndSample(double radius)
    {
        TileMeshBuilder builder = new(new FunctionGrid(2, (line, sample) => (line, sample) == (175, 3) ? radius : 1_737_400.0));

        BadInputException exception = Assert.Throws<BadInputException>(() => Build(builder, TileMeshLayout.For(new TileId(0, 0), 2)));

        Assert.Contains("line 176, sample 4;", exception.Message, StringComparison.Ordinal);
    }

    private static TileMesh Build(TileMeshBuilder builder, TileMeshLayout layout) => builder.Build(layout, builder.ReadRadii(layout));
}
