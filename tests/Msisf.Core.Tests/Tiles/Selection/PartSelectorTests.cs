using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Lod;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tiles;
using Msisf.Core.Tiles.Selection;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Tiles.Selection;

public sealed class PartSelectorTests(Ldem4Fixture ldem4, RuggedMoon rugged) : IClassFixture<Ldem4Fixture>, IClassFixture<RuggedMoon>
{
    private const int PixelsEach = 600;
    private static readonly int Cameras = TestLength.Of(24, 840);
    private static readonly Vector3D Sun = new(1.074955473280880E+011, -1.042430734878980E+011, 4.036164305561260E+009);

    [RequiresFact(Part.Ldem4)]
    public void Select_ExactPartsOfTheRealMoon_EveryPixelIsAsWithAllOfIt()
    {
        (int dropped, int selected) = CheckExactParts(ldem4.Grid, ldem4.Summary, subdivisions: 4, cells: 5);

        Assert.True(dropped > selected / 10, $"only {dropped} squares of kept tiles were left out beside {selected}: parts save nothing");
    }

    [Fact]
    public void Select_ExactPartsOfARuggedMoon_EveryPixelIsAsWithAllOfIt() =>
        CheckExactParts(rugged.Grid, rugged.Summary, subdivisions: 2, cells: 5);

    [Fact]
    public void Select_StripsOfAnImage_HaveTheirRowsAsWithAllOfTheMoon()
    {
        BruteForceMoon moon = new(rugged.Grid, 2);
        PartSelector selector = new(LodLevels.Open(rugged.Grid), rugged.Summary, 0.0, cells: 5);
        int whole = 0;
        int inStrips = 0;
        for (int number = 0; number < TestLength.Of(12, 36); number++)
        {
            (PinholeCamera camera, Vector3D sun, string kind) = CameraCases.Make(number, rugged.Grid, PixelsEach);
            BruteForceImage all = new(moon, camera, sun, isThere: null);
            PartSelection image = selector.Select(camera, sun);
            whole += image.Parts.Count;
            IReadOnlyList<PixelRows> strips = PixelRows.Strips(camera.Height, 2, unit: 4);
            foreach (PixelRows rows in strips)
            {
                PartArea area = new(selector.Select(camera, sun, rows).Parts);
                PartSelection parts = image with { Parts = [.. image.Parts.Where(area.Overlaps)] };
                inStrips += parts.Parts.Count;
                BruteForceImage strip = new(moon, camera, sun, TilesThere.In(parts, 2));
                Assert.True(
                    all.DifferencesFrom(strip, rows) == 0, $"camera {number} ({kind}), {rows}: {all.DifferencesFrom(strip, rows)} pixels");
            }
        }

        Assert.True(inStrips < 1.6 * whole, $"{inStrips} parts in strips, {whole} in whole images: strips save nothing");
    }

    [RequiresFact(Part.Ldem4)]
    public void Select_NoErrorAllowed_TakesTheModelItself()
    {
        (PinholeCamera camera, Vector3D sun, _) = CameraCases.Make(0, ldem4.Grid, PixelsEach);

        PartSelection selection = Selector(0.0).Select(camera, sun);

        TileSelection exact = Dspsa.Select(camera, sun, ldem4.Grid, ldem4.Summary);
        Assert.Equal(exact.Kept, selection.Tiles.Kept);
        Assert.All(selection.Parts, part => Assert.Equal(SurfacePart.Whole(part.Tile), part));
        Assert.Subset(exact.Kept.Select(choice => choice.Tile).ToHashSet(), selection.Parts.Select(part => part.Tile).ToHashSet());
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData(0.3, 1)]
    [InlineData(0.6, 2)]
    public void Select_DiscOfFewPixels_TakesTheLevelWhoseCellsAreTwiceTheErrorWide(double errorPixels, int level)
    {
        // 22.2 km a pixel where the Moon is nearest; cells are 7.6, 15.2 and 30.3 km wide.
        PinholeCamera camera = new(
            new Vector3D(1e9, 0.0, 0.0), UnitQuaternion.Identity, 2.0 * Math.Atan2(0.5 * 22.2e3 * 200, 998.26e6), 200, 200);

        PartSelection selection = Selector(errorPixels).Select(camera, new Vector3D(1.5e11, 0.0, 0.0));

        HashSet<TileId> visible = [.. selection.Tiles.Kept.Where(
            choice => choice.Reason == TileReason.Visible).Select(choice => choice.Tile)];
        Assert.Equal(
            visible.Order().Select(tile => SurfacePart.Whole(tile, level - 1)), selection.Parts.Where(part => visible.Contains(part.Tile)));
    }

    [RequiresFact(Part.Ldem4)]
    public void Select_CoarserLevels_HoldsAllVisibleTilesOfTheExactSelection()
    {
        for (int number = 0; number < TestLength.Of(12, 48); number++)
        {
            (PinholeCamera camera, Vector3D sun, _) = CameraCases.Make(number, ldem4.Grid, 100);

            HashSet<TileId> parts = [.. Selector(1.0).Select(camera, sun).Tiles.Kept.Select(choice => choice.Tile)];

            Assert.All(
                Dspsa.Select(camera, sun, ldem4.Grid, ldem4.Summary).Kept.Where(choice => choice.Reason == TileReason.Visible),
                choice => Assert.Contains(choice.Tile, parts));
        }
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData(double.NaN)]
    [InlineData(-0.1)]
    [InlineData(double.PositiveInfinity)]
    public void Constructor_ErrorOutOfRange_IsACallersBug(double errorPixels) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => Selector(errorPixels));

    [RequiresFact(Part.Ldem4)]
    public void Select_CameraInsideTheMoon_IsBadInput() => Assert.Throws<BadInputException>(() => Selector(0.3).Select(
        new PinholeCamera(new Vector3D(1.7e6, 0.0, 0.0), UnitQuaternion.Identity, 0.5, 64, 64), Sun));

    private static (int Dropped, int Selected) CheckExactParts(IGlobalGrid grid, ElevationSummary summary, int subdivisions, int cells)
    {
        BruteForceMoon moon = new(grid, subdivisions);
        PartSelector selector = new(LodLevels.Open(grid), summary, 0.0, cells);
        List<string> wrong = [];
        int dropped = 0;
        int selected = 0;
        for (int number = 5000; number < 5000 + Cameras; number++)
        {
            (PinholeCamera camera, Vector3D sun, string kind) = CameraCases.Make(number, grid, PixelsEach);
            PartSelection parts = selector.Select(camera, sun);
            bool[] isThere = TilesThere.In(parts, subdivisions);
            BruteForceImage whole = new(moon, camera, sun, isThere: null);
            int differ = whole.DifferencesFrom(new BruteForceImage(moon, camera, sun, isThere));
            bool[] withoutSun = TilesThere.In(selector.Select(camera, null), subdivisions);
            bool isAllThere = whole.HitTiles.Zip(withoutSun).All(square => !square.First || square.Second);
            selected += isThere.Count(there => there);
            dropped += (parts.Tiles.Kept.Count * subdivisions * subdivisions) - isThere.Count(there => there);
            if (differ > 0 || !isAllThere)
            {
                wrong.Add($"camera {number} ({kind}): {differ} pixels, all that is hit is there: {isAllThere}");
            }
        }

        Assert.Empty(wrong);
        return (dropped, selected);
    }

    private PartSelector Selector(double errorPixels) => new(LodLevels.Open(ldem4.Grid), ldem4.Summary, errorPixels);
}
