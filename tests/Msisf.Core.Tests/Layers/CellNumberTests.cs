using Msisf.Core.Layers;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;
using Xunit;

namespace Msisf.Core.Tests.Layers;

public class CellNumberTests
{
    [Theory]
    [InlineData(-1, 0, 0)] // the northern fan
    [InlineData(-1, 1439, 1439)]
    [InlineData(0, 0, 1440)]
    [InlineData(719, 1439, 1_038_239)] // the southern fan, 1440 * 721 - 1
    public void CellOf_CornersOfTheGrid_AreNumberedByLineThenSample(int line, int sample, long cell) =>
        Assert.Equal(cell, CellNumber.CellOf(new FacetId(line, sample, FacetHalf.NorthEast), 4));

    [Fact]
    public void CellOf_LastCellAt1024PixelsPerDegree_IsExactAsADouble()
    {
        long last = CellNumber.CellOf(new FacetId((180 * 1024) - 1, (360 * 1024) - 1, FacetHalf.NorthEast), 1024);

        Assert.Equal(67_948_093_439L, last); // 368640 * 184321 - 1
        Assert.Equal(last, (long)(double)last);
    }

    [Theory]
    [InlineData(-1, 0, 85, 0)]
    [InlineData(0, 1439, 85, 355)]
    [InlineData(19, 20, 85, 5)]
    [InlineData(20, 19, 80, 0)]
    [InlineData(719, 0, -90, 0)]
    public void TileOf_Cell_IsTheTileOfItsNorthWesternSample(int line, int sample, int south, int west)
    {
        int number = CellNumber.TileOf(new FacetId(line, sample, FacetHalf.SouthWest), 4);

        Assert.Equal(new TileId(south, west), TileId.All.ElementAt(number));
    }
}
