using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;
using Xunit;

namespace Msisf.Core.Tests.Tiles;

public class TileIdTests
{
    // docs/pattern-format.md, sections 1 and 2: a cell belongs to the tile that holds its north-west sample.
    [Theory]
    [InlineData(-1, 0, 85, 0)] // the northern fan
    [InlineData(-1, 1439, 85, 355)]
    [InlineData(0, 0, 85, 0)]
    [InlineData(19, 19, 85, 0)]
    [InlineData(20, 20, 80, 5)]
    [InlineData(359, 1420, 0, 355)]
    [InlineData(360, 1419, -5, 350)]
    [InlineData(719, 1439, -90, 355)] // the southern fan
    public void Holding_CellAtFourPixelsADegree_IsTheTileOfItsNorthWestSample(int line, int sample, int south, int west)
    {
        Assert.Equal(new TileId(south, west), TileId.Holding(new FacetId(line, sample, FacetHalf.SouthWest), 4));
        Assert.Equal(new TileId(south, west), TileId.Holding(new FacetId(line, sample, FacetHalf.NorthEast), 4));
    }

    // docs/deviations.md, row 12: latitude +90 belongs to the last row, longitude 360 to the first column.
    [Theory]
    [InlineData(0.0, 0.0, 0, 0)]
    [InlineData(-1e-9, 359.9, -5, 355)]
    [InlineData(-5.0, 5.0, -5, 5)]
    [InlineData(-5.1, 4.9, -10, 0)]
    [InlineData(90.0, 0.0, 85, 0)]
    [InlineData(-90.0, 180.0, -90, 180)]
    [InlineData(12.0, 360.0, 10, 0)]
    public void Containing_PointInDegrees_IsTheTileAroundIt(double latitude, double longitude, int south, int west)
    {
        SelenographicPoint point = new(double.DegreesToRadians(latitude), double.DegreesToRadians(longitude));

        Assert.Equal(new TileId(south, west), TileId.Containing(point));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(1024)]
    public void Holding_EachTilesCornerSamples_AreInTheTile(int pixelsPerDegree)
    {
        int last = (5 * pixelsPerDegree) - 1;
        foreach (TileId tile in TileId.All)
        {
            int line = tile.FirstLine(pixelsPerDegree);
            int sample = tile.FirstSample(pixelsPerDegree);

            Assert.Equal(tile, TileId.Holding(new FacetId(line, sample, FacetHalf.SouthWest), pixelsPerDegree));
            Assert.Equal(tile, TileId.Holding(new FacetId(line + last, sample + last, FacetHalf.SouthWest), pixelsPerDegree));
        }
    }
}
