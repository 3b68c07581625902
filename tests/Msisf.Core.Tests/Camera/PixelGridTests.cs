using Msisf.Core.Camera;
using Xunit;

namespace Msisf.Core.Tests.Camera;

public class PixelGridTests
{
    [Theory]
    [InlineData(1024, 50, 20, 50, 1000)]
    [InlineData(1000, 50, 20, 50, 1000)]
    [InlineData(999, 50, 19, 50, 950)]
    [InlineData(64, 1, 64, 1, 64)]
    [InlineData(64, 64, 1, 64, 64)]
    [InlineData(1, 1, 1, 1, 1)]
    public void Constructor_Spacing_TakesItsMultiples(int size, int spacing, int count, int first, int last)
    {
        PixelGrid grid = new(size, 7, spacing, 7);
        PixelGrid turned = new(7, size, 7, spacing);

        Assert.Equal((count, 1), (grid.Columns, grid.Rows));
        Assert.Equal((first, last), (grid.PixelX(0), grid.PixelX(count - 1)));
        Assert.Equal((1, count), (turned.Columns, turned.Rows));
        Assert.Equal((first, last), (turned.PixelY(0), turned.PixelY(count - 1)));
    }

    [Theory]
    [InlineData(65)]
    [InlineData(int.MaxValue)]
    public void Constructor_SpacingLargerThanImage_TakesNone(int spacing)
    {
        PixelGrid grid = new(64, 64, spacing, spacing);

        Assert.Equal((0, 0), (grid.Columns, grid.Rows));
    }

    [Theory]
    [InlineData(0, 1)]
    [InlineData(1, 0)]
    [InlineData(-50, 50)]
    public void Constructor_SpacingBelow1_IsACallersBug(int spacingH, int spacingV) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new PixelGrid(64, 64, spacingH, spacingV));
}
