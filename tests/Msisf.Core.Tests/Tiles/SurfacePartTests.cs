using Msisf.Core.Tiles;
using Xunit;

namespace Msisf.Core.Tests.Tiles;

public class SurfacePartTests
{
    [Theory]
    [InlineData(1, 1)]
    [InlineData(8, 1)]
    [InlineData(16, 2)]
    [InlineData(64, 8)]
    [InlineData(512, 64)]
    [InlineData(1024, 128)]
    [InlineData(360, 8)] // 45 parts are wanted, but a tile's 1800 cells are no whole number of times 16
    [InlineData(75, 1)]
    public void SubdivisionsAt_AnyResolution_GivesWholeCells(int pixelsPerDegree, int expected) =>
        Assert.Equal(expected, SurfacePart.SubdivisionsAt(pixelsPerDegree));

    [Fact]
    public void NameText_TileOfTheModel_IsThePatternsName() =>
        Assert.Equal("lat_-5_0_lon_355_360", SurfacePart.Whole(new TileId(-5, 355)).NameText);

    [Fact]
    public void NameText_Part_SaysLevelAndPlace()
    {
        Assert.Equal("lat_0_5_lon_15_20_level_1_part_0_1_of_2", new SurfacePart(new TileId(0, 15), 1, 2, 0, 1).NameText);
        Assert.Equal("lat_0_5_lon_15_20_level_3_part_0_0_of_1", SurfacePart.Whole(new TileId(0, 15), 3).NameText);
        Assert.Equal("lat_0_5_lon_15_20_level_0_part_3_2_of_4", new SurfacePart(new TileId(0, 15), 0, 4, 3, 2).NameText);
    }

    [Fact]
    public void Quarters_Part_FillIt()
    {
        SurfacePart part = new(new TileId(0, 15), 1, 2, 1, 0);

        Assert.Equal([(2, 0), (2, 1), (3, 0), (3, 1)], part.Quarters().Select(quarter => (quarter.Row, quarter.Column)));
        Assert.All(part.Quarters(), quarter => Assert.Equal((part.Tile, 1, 4), (quarter.Tile, quarter.Level, quarter.Subdivisions)));
    }

    [Fact]
    public void CompareTo_Parts_OrdersByTileFirst()
    {
        SurfacePart[] ordered =
        [
            SurfacePart.Whole(new TileId(-5, 0)), new(new TileId(0, 0), 0, 4, 0, 1), new(new TileId(0, 0), 0, 4, 1, 0),
            new(new TileId(0, 0), 1, 2, 0, 0), SurfacePart.Whole(new TileId(0, 5)),
        ];

        Assert.Equal(ordered, ordered.Reverse().Order());
    }
}
