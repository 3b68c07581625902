using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Mesh.Bounds;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tiles;
using Msisf.Core.Tiles.Selection;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Tiles.Selection;

/// <summary>What is kept in reserve where coarser levels may be drawn.</summary>
public sealed class DetailRuleTests(RuggedMoon rugged) : IClassFixture<RuggedMoon>
{
    private const int Resolution = 8;

    /// <summary>From afar, where levels are coarser than the model, more tiles count as seen than without the reserve.</summary>
    [Fact]
    public void Slack_FarViewsOfARuggedMoon_KeepsWhatIsHiddenByLess()
    {
        const double error = 1.0;
        PartSelector selector = new(LodLevels.Open(rugged.Grid), rugged.Summary, error);
        int added = 0;
        for (int number = 0; number < 6; number++)
        {
            (PinholeCamera camera, Vector3D sun, string kind) = CameraCases.Make(number, rugged.Grid, 100);
            DetailRule rule = new(camera, error, rugged.Grid.PixelsPerDegree, LodLevels.CountOf(rugged.Grid.PixelsPerDegree));
            if (rule.CoarsestLevel(rugged.Summary) > 0)
            {
                TileId[] without = Seen(new DspsaRun(camera, sun, rugged.Grid, rugged.Summary, rule.MarginPixels).Select());
                TileId[] with = Seen(selector.Select(camera, sun).Tiles);
                Assert.True(without.All(with.Contains), $"camera {number} ({kind})");
                added += with.Length - without.Length;
            }
        }

        Assert.True(added > 0, "no tile is added");
    }

    [Fact]
    public void Slack_HalfAPixelOfError_IsFourPixels()
    {
        // tan 45 degrees is 500 px wide: 2 mrad a pixel.
        PinholeCamera camera = Looking(new Vector3D(2e6, 0.0, 0.0), Math.PI / 2.0, 1000, 1000);

        Assert.Equal(0.008, new DetailRule(camera, 0.5, Resolution, 4).Slack, 1e-12);
    }

    /// <summary>
    /// From 0.2 radii over (0, 2.5) the meridian of 5 degrees is seen at tan = 0.2171 beside the nadir. The image ends 2 of its 20 pixels before
    /// that. Antialiasing reaches 1 pixel beyond, an error of a pixel 2 more.
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
