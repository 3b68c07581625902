using Msisf.Core.Tiles;
using Xunit;

namespace Msisf.Core.Tests.Tiles;

public sealed class PartAreaTests
{
    private static readonly TileId Tile = new(0, 15);

    /// <summary>The south-western quarter's north-western quarter, and another whole tile.</summary>
    private static readonly PartArea Area = new([new SurfacePart(Tile, 1, 4, 2, 0), SurfacePart.Whole(new TileId(5, 15), 3)]);

    [Theory]
    [InlineData(1, 0, 0, true)] // the tile around it
    [InlineData(2, 1, 0, true)]
    [InlineData(2, 0, 0, false)]
    [InlineData(2, 1, 1, false)]
    [InlineData(4, 2, 0, true)] // itself, at any level
    [InlineData(4, 3, 0, false)]
    [InlineData(8, 5, 1, true)] // in it
    [InlineData(8, 6, 1, false)]
    [InlineData(64, 32, 15, true)]
    [InlineData(64, 32, 16, false)]
    public void Overlaps_SquaresOfTheTile_AreThoseInItAndAroundIt(int subdivisions, int row, int column, bool expected)
    {
        Assert.Equal(expected, Area.Overlaps(new SurfacePart(Tile, 0, subdivisions, row, column)));
        Assert.Equal(expected, Area.Overlaps(new SurfacePart(Tile, 2, subdivisions, row, column)));
    }

    [Fact]
    public void Overlaps_OtherTiles_AreToldApart()
    {
        Assert.True(Area.Overlaps(new SurfacePart(new TileId(5, 15), 0, 8, 7, 7)));
        Assert.False(Area.Overlaps(SurfacePart.Whole(new TileId(5, 20))));
    }
}
