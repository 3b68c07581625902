using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tiles;
using Msisf.Core.Tiles.Selection;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Tiles.Selection;

public sealed class DspsaTests(Ldem4Fixture ldem4) : IClassFixture<Ldem4Fixture>
{
    private const int PixelsEach = 600;
    private static readonly int Cameras = TestLength.Of(36, 204); // of twelve kinds in turn
    private static readonly Vector3D Sun = new(1.074955473280880E+011, -1.042430734878980E+011, 4.036164305561260E+009);

    [RequiresFact(Part.Ldem4)]
    public void Select_ManyCamerasWithSun_EveryPixelIsAsWithAllTiles()
    {
        List<string> wrong = [];
        int lit = 0;
        int dropped = 0;
        for (int number = 0; number < Cameras; number++)
        {
            (PinholeCamera camera, Vector3D sun, string kind) = CameraCases.Make(number, ldem4.Grid, PixelsEach);
            TileSelection selection = ldem4.Selection.Select(camera, sun);
            BruteForceImage whole = new(ldem4.Moon, camera, sun, isThere: null);
            BruteForceImage selected = new(ldem4.Moon, camera, sun, TilesThere.In(selection));
            lit += whole.Lit;
            dropped += TileId.Count - selection.Kept.Count;
            if (whole.DifferencesFrom(selected) > 0)
            {
                wrong.Add($"camera {number} ({kind}): {whole.DifferencesFrom(selected)} pixels");
            }
        }

        Assert.Empty(wrong);
        Assert.True(lit > 49 * Cameras, $"only {lit} lit pixels: the cameras show nothing");
        Assert.True(dropped > Cameras * TileId.Count / 2, $"only {dropped} tiles were dropped");
    }

    /// <summary>
    /// The scene of thesis section 9.2, where it shows the limb in the night: without dark tiles there, rays go through the Moon and meet
    /// facets beyond the limb from below, on which the Sun shines.
    /// </summary>
    [RequiresFact(Part.Ldem4)]
    public void Select_LimbInTheNight_EveryPixelIsAsWithAllTiles()
    {
        UnitQuaternion attitude = UnitQuaternion.FromComponents(
            -2.391176183943345e-001, 9.904576054128762e-002, 3.696438106143861e-001, 8.923991008325228e-001, isRounded: true);
        PinholeCamera camera = new(new Vector3D(2e6, 2e6, 0.0), attitude, double.DegreesToRadians(40.0), 384, 384);
        PixelRows limb = new(39, 43);
        BruteForceImage whole = new(ldem4.Moon, camera, Sun, isThere: null, limb);
        BruteForceImage selected = new(ldem4.Moon, camera, Sun, TilesThere.In(ldem4.Selection.Select(camera, Sun)), limb);

        Assert.Equal(0, whole.DifferencesFrom(selected));
        Assert.Contains(true, whole.HitTiles);
    }

    [RequiresFact(Part.Ldem4)]
    public void Select_ManyCamerasIgnoringSun_HoldsEveryTileThatAnyRayHits()
    {
        List<string> missed = [];
        for (int number = 1000; number < 1000 + Cameras; number++)
        {
            (PinholeCamera camera, _, string kind) = CameraCases.Make(number, ldem4.Grid, PixelsEach);
            bool[] isThere = TilesThere.In(ldem4.Selection.Select(camera, null));
            bool[] isHit = new BruteForceImage(ldem4.Moon, camera, Sun, isThere: null).HitTiles;
            missed.AddRange(
                Enumerable.Range(0, TileId.Count).Where(tile => isHit[tile] && !isThere[tile]).Select(
                    tile => $"camera {number} ({kind}): tile {tile}"));
        }

        Assert.Empty(missed);
    }

    /// <summary>
    /// A tile counts as seen if one of its vertices or facet middles can be: pixels would miss slivers that antialiasing meets.
    /// </summary>
    [RequiresFact(Part.Ldem4)]
    public void Select_ManyCamerasIgnoringSun_KeepsAtMost20PercentMoreThanIsSeen()
    {
        int kept = 0;
        int seen = 0;
        for (int number = 0; number < TestLength.Of(12, 24); number++)
        {
            (PinholeCamera camera, _, _) = CameraCases.Make(number, ldem4.Grid, 1_000_000);
            TileSelection selection = ldem4.Selection.Select(camera, null);
            kept += selection.Kept.Count;
            seen += selection.Kept.Count(choice => TileSight.IsSeen(ldem4.Moon, camera, choice.Tile));
        }

        Assert.InRange((double)kept / seen, 1.0, 1.2);
    }

    [RequiresFact(Part.Ldem4)]
    public void Select_SameTwice_ChoosesTheSame()
    {
        (PinholeCamera camera, Vector3D sun, _) = CameraCases.Make(1, ldem4.Grid, 10_000);

        Assert.Equal(
            ldem4.Selection.Select(camera, sun).All,
            ldem4.Selection.Select(camera, sun).All);
    }

    [RequiresFact(Part.Ldem4)]
    public void Select_AnyCamera_ListsEachTileOnceInOrder()
    {
        (PinholeCamera camera, Vector3D sun, _) = CameraCases.Make(3, ldem4.Grid, 10_000);
        TileSelection selection = ldem4.Selection.Select(camera, sun);

        Assert.Equal(TileId.All, selection.All.Select(choice => choice.Tile));
        Assert.Equal(selection.All.Where(choice => choice.IsKept), selection.Kept);
    }

    [RequiresFact(Part.Ldem4)]
    public void Select_MoonOutOfView_KeepsNothing()
    {
        PinholeCamera camera = new(new Vector3D(4e6, 0.0, 0.0), CameraCases.Attitude(Vector3D.UnitX, Vector3D.UnitY), 0.7, 64, 64);

        TileSelection selection = ldem4.Selection.Select(camera, Sun);

        Assert.Empty(selection.Kept);
        Assert.All(selection.All, choice => Assert.Equal(TileReason.OutsideFrame, choice.Reason));
    }

    [RequiresFact(Part.Ldem4)]
    public void Select_DiscWithSunBehindTheMoon_KeepsNoTileInTheMiddle()
    {
        PinholeCamera camera = new(new Vector3D(8e6, 0.0, 0.0), UnitQuaternion.Identity, 0.5, 512, 512);

        TileSelection selection = ldem4.Selection.Select(camera, new Vector3D(-1.5e11, 0.0, 0.0));

        TileChoice middle = selection.All.Single(choice => choice.Tile == new TileId(0, 0));
        Assert.Equal(TileReason.Night, middle.Reason);
        Assert.Equal("night", middle.ReasonText);
    }

    [RequiresFact(Part.Ldem4)]
    public void Select_OnThePolarAxis_KeepsAllTilesAroundThePole()
    {
        PinholeCamera camera = new(
            new Vector3D(0.0, 0.0, 1.9e6), CameraCases.Attitude(-Vector3D.UnitZ, Vector3D.UnitX), 0.5, 64, 64);

        TileSelection selection = ldem4.Selection.Select(camera, null);

        Assert.Equal(TileId.Columns, selection.Kept.Count(choice => choice.Tile.SouthDegrees == 85));
    }

    [RequiresFact(Part.Ldem4)]
    public void Select_CameraInsideTheMoon_IsBadInput()
    {
        PinholeCamera camera = new(new Vector3D(1.7e6, 0.0, 0.0), UnitQuaternion.Identity, 0.5, 64, 64);

        BadInputException exception = Assert.Throws<BadInputException>(() => ldem4.Selection.Select(camera, null));

        Assert.Contains("inside the Moon", exception.Message, StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4)]
    public void Select_SunInsideTheMoon_IsBadInput()
    {
        PinholeCamera camera = new(new Vector3D(4e6, 0.0, 0.0), UnitQuaternion.Identity, 0.5, 64, 64);

        Assert.Throws<BadInputException>(() => ldem4.Selection.Select(camera, new Vector3D(1e6, 0.0, 0.0)));
    }
}
