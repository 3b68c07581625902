using System.Globalization;
using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Tests.Support;
using Xunit;

namespace Msisf.Core.Tests.Lod;

/// <summary>
/// Levels of the scene "five": cells of 30.3 km, 4 km (400 km wide), 600 m, 100 m and 20 m (1.3 km wide), around the south pole but for the
/// two finest, which lie some 20 km beside it.
/// </summary>
public sealed class SceneDetailTests
{
    private const double Pixel = 1e-3;

    /// <summary>With an error of 0.5 px a cell is as wide as a pixel at most: at 10 km that is 10 m.</summary>
    [Theory]
    [InlineData(10.0, "0,0,0,0,0")]
    [InlineData(10e3, "0,0,0,0,0")]
    [InlineData(41e3, "0,0,0,0,1")]
    [InlineData(90e3, "0,0,0,0,2")] // 80 m, the coarsest of 16 samples a side
    [InlineData(130e3, "0,0,0,0,-")] // those of 100 m do
    [InlineData(250e3, "0,0,0,1,-")]
    [InlineData(700e3, "0,0,0,-,-")]
    [InlineData(1300e3, "0,0,1,-,-")]
    [InlineData(4500e3, "0,0,-,-,-")]
    [InlineData(40000e3, "0,-,-,-,-")]
    public void LevelsFor_CameraOverTheFinest_AreAsCoarseAsItsHeightAllows(double height, string levels) =>
        Assert.Equal(levels, LevelsAt(MiddleOfTheFinest, height));

    /// <summary>100 m high, 45 km beyond the pole: the site is 64 km away, the map of 100 m around it 61 km.</summary>
    [Fact]
    public void LevelsFor_CameraBesideTheSite_AreThoseOfItsDistance()
    {
        Vector3D site = MiddleOfTheFinest;
        Assert.Equal("0,0,0,0,1", LevelsAt(new Vector3D(-2.25 * site.X, -2.25 * site.Y, site.Z).Normalized(), 100.0));
    }

    /// <summary>3,000 km over the equator the maps are 4,900 km away.</summary>
    [Fact]
    public void LevelsFor_CameraFarFromTheMaps_LeavesTheFineOnesOut() =>
        Assert.Equal("0,0,-,-,-", LevelsAt(new Vector3D(1.0, 0.0, 0.0), 3e6));

    [Fact]
    public void LevelsFor_NoErrorAllowed_AreThoseOfTheModels()
    {
        SceneDetail detail = new(NestedScenes.LevelsOf("five"), 0.0);
        Vector3D right = Vector3D.Cross(MiddleOfTheFinest, Vector3D.UnitX).Normalized();
        PinholeCamera camera = new(
            1e8 * MiddleOfTheFinest, CameraCases.Attitude(-MiddleOfTheFinest, right), fieldOfView: 0.1, width: 64, height: 64);
        Assert.Same(NestedScenes.Named("five"), detail.For(camera, 1));
    }

    /// <summary>The level of what crosses the border of a coarser model is its own, even where that would be fine enough.</summary>
    [Fact]
    public void LevelsFor_CrossingModel_IsNotLeftOutForTheOneItCrosses()
    {
        SceneDetail detail = new(NestedScenes.LevelsOf("crossing"), 0.5);
        Vector3D place = NestedScenes.Named("crossing").Models[2].Projection.DirectionOf(40.0, 40.0);
        Assert.Equal((int?[])[0, 0, 2], detail.LevelsFor(FootprintAt(place, 6e6), 1)); // 5 km cells would do
    }

    private static Vector3D MiddleOfTheFinest => NestedScenes.Named("five").Models[^1].Projection.DirectionOf(32.0, 32.0);

    private static string LevelsAt(Vector3D direction, double height) => string.Join(
        ',', new SceneDetail(NestedScenes.LevelsOf("five"), 0.5).LevelsFor(FootprintAt(direction, height), 1).Select(
            level => level?.ToString(CultureInfo.InvariantCulture) ?? "-"));

    private static PixelFootprint FootprintAt(Vector3D direction, double height) => new(
        (TerrainHeight.RadiusBelow(NestedScenes.Named("five"), direction) + height) * direction, -1.0 * direction, Pixel, 1.0);
}
