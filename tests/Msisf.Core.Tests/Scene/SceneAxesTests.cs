using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Xunit;

namespace Msisf.Core.Tests.Scene;

public sealed class SceneAxesTests
{
    /// <summary>Units are to be a 16th of a cell or less, so that POV-Ray sees casters near a point; it draws nothing beyond 1e7.</summary>
    [Theory]
    [InlineData(1.74e6, 7581.0, 4.0)]
    [InlineData(1.74e6, 2000.0, 8.0)]
    [InlineData(1.74e6, 1999.0, 16.0)]
    [InlineData(1.74e6, 64000.0, 1.0)]
    [InlineData(1.74e6, 1e6, 1.0)]
    [InlineData(1.74e6, 1.0, 1024.0)] // 5e9 m / 3.5e6 m, rounded down
    [InlineData(1e9, 1.0, 4.0)]
    [InlineData(1e10, 1.0, 1.0)]
    public void For_CameraAndCell_HasAUnitNoWiderThanACellAndReachesTheGround(double distance, double cell, double expected)
    {
        Vector3D camera = new(0.0, distance, 0.0);
        SceneAxes axes = SceneAxes.For(camera, MoonConstants.ReferenceRadius, cell);
        Assert.Equal(expected, axes.UnitsPerKilometre);
        Assert.Equal(default, axes.At(camera));
        Assert.True(expected == 1.0 || axes.At(new Vector3D(0.0, -MoonConstants.ReferenceRadius, 0.0)).Length < 1e7);
    }

    /// <summary>
    /// A block stays in POV-Ray's tree of boxes, whatever the width of its cells and wherever it faces: its box is below 2e10 cubic units.
    /// The box of a square is largest if all axes lie as steeply to it.
    /// </summary>
    [Fact]
    public void For_AnyCell_BlocksHaveFiniteBoxes()
    {
        for (double cell = 1.0; cell < 10_000.0; cell *= 1.07)
        {
            double side = CellBlock.Size * cell / 1000.0 * SceneAxes.For(default, MoonConstants.ReferenceRadius, cell).UnitsPerKilometre;
            double longest = side * Math.Sqrt(2.0) * Math.Sqrt(4.0 / 3.0);
            Assert.InRange(longest * longest * longest, 0.0, 1e10);
        }
    }

    [Fact]
    public void At_AnyPoint_CountsFromTheOriginInUnits()
    {
        SceneAxes axes = new(new Vector3D(1000.0, 2000.0, -3000.0), 8.0);
        Assert.Equal(new Vector3D(8.0, -16.0, 0.5), axes.At(new Vector3D(2000.0, 0.0, -2937.5)));
    }
}
