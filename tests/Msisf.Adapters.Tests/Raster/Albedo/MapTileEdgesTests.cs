using Msisf.Adapters.Raster.Albedo;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Albedo;

public sealed class MapTileEdgesTests
{
    /// <summary>400 m a pixel: a tile of 90 degrees has 6822.75 pixels, in whole ones 6823.</summary>
    [Fact]
    public void Of_SizesThatAreRounded_TouchInWholePixels()
    {
        MapTileEdges edges = MapTileEdges.Of([(0.0, 6823), (6822.75, 6823), (13645.5, 6823), (20468.25, 6823)]);

        Assert.Equal([0, 6823, 13646, 20469, 27292], edges.Positions);
        Assert.Equal([(0, 1), (1, 2), (2, 3), (3, 4)], edges.Tiles);
    }

    [Theory]
    [InlineData(101.0, "0 100 101 201", "0-1 2-3")]
    [InlineData(99.0, "0 99 100 199", "0-2 1-3")]
    public void Of_APixelMoreOrLess_IsAGapOrAnOverlap(double second, string positions, string tiles)
    {
        MapTileEdges edges = MapTileEdges.Of([(0.0, 100), (second, 100)]);

        Assert.Equal(positions, string.Join(' ', edges.Positions));
        Assert.Equal(tiles, string.Join(' ', edges.Tiles.Select(tile => $"{tile.First}-{tile.End}")));
    }
}
