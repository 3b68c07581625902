using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Lod;

/// <summary>Levels of detail.</summary>
public sealed class DetailRuleTests
{
    /// <summary>tan 45 degrees is 500 px wide: a pixel is 2 mrad wide in the middle of the image.</summary>
    [Fact]
    public void Footprint_RightAngleOf1000Pixels_Is2MillimetresPerMetre() =>
        Assert.Equal(0.002, Looking(new Vector3D(2e6, 0.0, 0.0), Math.PI / 2.0, 1000, 1000).Footprint.Tangent, Rounding.OfChains);

    /// <summary>
    /// A degree of the reference sphere is 30 323.350 m: at 4 px/deg cells are 7580.838 m wide, then 15 161.675 m, then 30 323.350 m.
    /// </summary>
    [Theory]
    [InlineData(0.0, 0)]
    [InlineData(15_161.67, 0)]
    [InlineData(15_161.68, 1)]
    [InlineData(30_323.34, 1)]
    [InlineData(30_323.36, 2)]
    [InlineData(1e9, 2)]
    public void LevelOfCell_WidestCell_IsTheLastLevelThatFits(double widestCell, int level)
    {
        Assert.Equal(level, new DetailRule(LodLevels.Open(FunctionGrid.Rough(4)), 0.5).LevelOfCell(widestCell));
    }

    private static PinholeCamera Looking(Vector3D position, double fieldOfView, int width, int height) =>
        new(position, NadirPointing.MoonFromCamera(position), fieldOfView, width, height);
}
