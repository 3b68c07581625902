using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tiles;
using Msisf.Core.Tiles.Selection;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Lod;

/// <summary>Levels of detail, and what is kept in reserve where coarser ones may be drawn.</summary>
public sealed class DetailRuleTests(RuggedMoon rugged) : IClassFixture<RuggedMoon>
{
    private const int Resolution = 8;

    /// <summary>From afar, where levels are coarser than the model, more tiles count as seen than without the reserve.</summary>
    [Fact]
    public void Slack_FarViewsOfARuggedMoon_KeepsWhatIsHiddenByLess()
    {
        const double error = 1.0;
        LodLevels levels = LodLevels.Open(rugged.Grid);
        DetailRule rule = new(levels, error);
        PartSelector selector = new(levels, rugged.Summary, error);
        int added = 0;
        for (int number = 0; number < 6; number++)
        {
            (PinholeCamera camera, Vector3D sun, string kind) = CameraCases.Make(number, rugged.Grid, 100);
            if (selector.CoarsestLevelInSight(camera.Footprint) > 0)
            {
                ViewFrustum frame = new(camera, Dspsa.AntialiasingPixels + rule.MarginPixels);
                TileId[] without = Seen(new DspsaRun(frame, sun, rugged.Grid, rugged.Summary).Select());
                TileId[] with = Seen(selector.Select(camera, sun).Tiles);
                Assert.True(without.All(with.Contains), $"camera {number} ({kind})");
                added += with.Length - without.Length;
            }
        }

        Assert.True(added > 0, "no tile is added");
    }

    [Fact]
    public void SlackPixels_HalfAPixelOfError_IsFourPixels() =>
        Assert.Equal(4.0, new DetailRule(LodLevels.Open(rugged.Grid), 0.5).SlackPixels);

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

    /// <summary>
    /// From 0.2 radii over (0, 2.5) the meridian of 5 degrees is seen at tan = 0.2171 beside the nadir. The image ends 2 of its 20 pixels
    /// before that. Antialiasing reaches 1 pixel beyond, an error of a pixel 2 more.
    /// </summary>
    [Fact]
    public void MarginPixels_GroundBesideTheImage_IsThere()
    {
        FunctionGrid smooth = FunctionGrid.OfHeights(Resolution, (_, _) => 0.0);
        double longitude = 2.5 * Math.PI / 180.0;
        Vector3D position = 1.2 * MoonConstants.ReferenceRadius * new Vector3D(Math.Cos(longitude), Math.Sin(longitude), 0.0);
        double halfWidth = Math.Sin(longitude) / (1.2 - Math.Cos(longitude)) / (1.0 + (2.0 * 2.0 / 20.0));
        PinholeCamera camera = Looking(position, 2.0 * Math.Atan(halfWidth), 20, 2);

        Assert.All(Select(smooth, camera, 0.0), part => Assert.Equal(0, part.Tile.WestDegrees));
        Assert.Equal([0, 5, 355], Select(smooth, camera, 1.0).Select(part => part.Tile.WestDegrees).Distinct().Order());
    }

    private static TileId[] Seen(TileSelection tiles) =>
        [.. tiles.Kept.Where(choice => choice.Reason == TileReason.Visible).Select(choice => choice.Tile)];

    private static PinholeCamera Looking(Vector3D position, double fieldOfView, int width, int height) =>
        new(position, NadirPointing.MoonFromCamera(position), fieldOfView, width, height);

    private static IReadOnlyList<SurfacePart> Select(FunctionGrid grid, PinholeCamera camera, double errorPixels) =>
        new PartSelector(LodLevels.Open(grid), ElevationSummary.Build(grid), errorPixels).Select(camera, null).Parts;
}
