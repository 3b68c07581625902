using Msisf.Core.Camera;
using Xunit;

namespace Msisf.Core.Tests.Camera;

public class PixelRowsTests
{
    [Theory]
    [InlineData(1024, 1, new[] { 0 })]
    [InlineData(1024, 2, new[] { 0, 512 })]
    [InlineData(1024, 3, new[] { 0, 320, 672 })]
    [InlineData(100, 3, new[] { 0, 32, 64 })]
    [InlineData(33, 8, new[] { 0, 32 })]
    [InlineData(7, 8, new[] { 0 })]
    public void Strips_AnyHeight_FillTheImageFromMultiplesOfTheUnit(int height, int strips, int[] firstRows)
    {
        IReadOnlyList<PixelRows> rows = PixelRows.Strips(height, strips, unit: 32);

        Assert.Equal(firstRows, rows.Select(strip => strip.First));
        Assert.Equal([.. firstRows.Skip(1), height], rows.Select(strip => strip.End));
    }
}
