using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Lod;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
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
    private static readonly Lazy<MemoryElevationGrid> Fine = new(() => Refined(MemoryElevationGrid.Ldem4(), 4));

    [RequiresFact(Part.Ldem4)]
    public void Select_ManyCamerasWithSun_EveryPixelIsAsWithAllTiles()
    {
        List<string> wrong = [];
        int lit = 0;
        int dropped = 0;
        for (int number = 0; number < Cameras; number++)
        {
            (PinholeCamera camera, Vector3D sun, string kind) = CameraCases.Make(number, ldem4.Grid, PixelsEach);
            TileSelection selection = Dspsa.Select(camera, sun, ldem4.Grid, ldem4.Summary);
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

    [RequiresFact(Part.Ldem4)]
    public void Select_ManyCamerasIgnoringSun_HoldsEveryTileThatAnyRayHits()
    {
        List<string> missed = [];
        for (int number = 1000; number < 1000 + Cameras; number++)
        {
            (PinholeCamera camera, _, string kind) = CameraCases.Make(number, ldem4.Grid, PixelsEach);
            bool[] isThere = TilesThere.In(Dspsa.Select(camera, null, ldem4.Grid, ldem4.Summary));
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
    public void Select_ManyCamerasIgnoringSun_KeepsAtMost15PercentMoreThanIsSeen()
    {
        int kept = 0;
        int seen = 0;
        for (int number = 0; number < TestLength.Of(12, 24); number++)
        {
            (PinholeCamera camera, _, _) = CameraCases.Make(number, ldem4.Grid, 1_000_000);
            TileSelection selection = Dspsa.Select(camera, null, ldem4.Grid, ldem4.Summary);
            kept += selection.Kept.Count;
            seen += selection.Kept.Count(choice => TileSight.IsSeen(ldem4.Moon, camera, choice.Tile));
        }

        Assert.InRange((double)kept / seen, 1.0, 1.15);
    }

    /// <summary>
    /// Of coarser models facets of the blocks are read up to a budget, which is spent on other blocks where bounds are not known; their
    /// summaries are made at once.
    /// </summary>
    [RequiresFact(Part.Ldem4)]
    public void Select_SummaryOnDemand_ChoosesTheSameAndReadsLess()
    {
        MemoryElevationGrid fine = Fine.Value;
        ElevationSummary known = ElevationSummary.Build(fine);
        LodLevels levels = LodLevels.Open(fine);
        ElevationSummary collected = ElevationSummary.OnDemand(fine);
        long read = 0;
        long whole = 0;
        for (int number = 0; number < TestLength.Of(2 * CameraCases.Kinds, 204); number++)
        {
            (PinholeCamera camera, Vector3D sun, string kind) = CameraCases.Make(number, fine, 1_000_000);
            if (TestLength.Of(1, 0) == 1 && number % CameraCases.Kinds is < 2 or > 5)
            {
                continue; // far views take seconds
            }

            Vector3D? light = number % 4 == 3 ? null : sun;
            ElevationSummary onDemand = ElevationSummary.OnDemand(fine);

            PartSelection expected = new PartSelector(levels, known, number % 2 / 3.0).Select(camera, light);
            PartSelection selected = new PartSelector(levels, onDemand, number % 2 / 3.0).Select(camera, light);

            Assert.True(expected.Tiles.Kept.SequenceEqual(selected.Tiles.Kept), $"camera {number} ({kind}): other tiles");
            Assert.True(expected.Parts.SequenceEqual(selected.Parts), $"camera {number} ({kind}): other parts");
            Assert.Equal(selected.Tiles.All, Dspsa.Select(camera, light, fine, onDemand).All); // whatever was known
            Assert.Equal(selected.Tiles.All, Dspsa.Select(camera, light, fine, collected).All);
            read += onDemand.SamplesRead;
            whole += 180L * 360 * 16 * 16;
        }

        Assert.InRange(read, whole / 10_000, whole / TestLength.Of(20, 2));
    }

    /// <summary>Of a tile that is mostly beside the image, only the blocks in it are read.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Select_SummaryOnDemandLookingDown_ReadsAFractionOfTheTile()
    {
        MemoryElevationGrid fine = Fine.Value;
        ElevationSummary onDemand = ElevationSummary.OnDemand(fine);
        Vector3D up = new Vector3D(0.9, 0.4, 0.2).Normalized();
        PinholeCamera camera = new(
            (TerrainHeight.RadiusBelow(fine, up) + 5e3) * up, CameraCases.Attitude(-up, Vector3D.UnitZ), 0.7, 256, 256);

        TileSelection selection = Dspsa.Select(camera, 1.5e11 * new Vector3D(0.9, 0.0, 0.4).Normalized(), fine, onDemand);

        Assert.NotEmpty(selection.Kept);
        Assert.InRange(onDemand.SamplesRead, 1, 80 * 80 / 2);
    }

    [RequiresFact(Part.Ldem4)]
    public void Select_SameTwice_ChoosesTheSame()
    {
        (PinholeCamera camera, Vector3D sun, _) = CameraCases.Make(1, ldem4.Grid, 10_000);

        Assert.Equal(
            Dspsa.Select(camera, sun, ldem4.Grid, ldem4.Summary).All,
            Dspsa.Select(camera, sun, ldem4.Grid, ldem4.Summary).All);
    }

    [RequiresFact(Part.Ldem4)]
    public void Select_AnyCamera_ListsEachTileOnceInOrder()
    {
        (PinholeCamera camera, Vector3D sun, _) = CameraCases.Make(3, ldem4.Grid, 10_000);
        TileSelection selection = Dspsa.Select(camera, sun, ldem4.Grid, ldem4.Summary);

        Assert.Equal(TileId.All, selection.All.Select(choice => choice.Tile));
        Assert.Equal(selection.All.Where(choice => choice.IsKept), selection.Kept);
    }

    [RequiresFact(Part.Ldem4)]
    public void Select_MoonOutOfView_KeepsNothing()
    {
        PinholeCamera camera = new(new Vector3D(4e6, 0.0, 0.0), CameraCases.Attitude(Vector3D.UnitX, Vector3D.UnitY), 0.7, 64, 64);

        TileSelection selection = Dspsa.Select(camera, Sun, ldem4.Grid, ldem4.Summary);

        Assert.Empty(selection.Kept);
        Assert.All(selection.All, choice => Assert.Equal(TileReason.OutsideFrame, choice.Reason));
    }

    [RequiresFact(Part.Ldem4)]
    public void Select_DiscWithSunBehindTheMoon_KeepsNoTileInTheMiddle()
    {
        PinholeCamera camera = new(new Vector3D(8e6, 0.0, 0.0), UnitQuaternion.Identity, 0.5, 512, 512);

        TileSelection selection = Dspsa.Select(camera, new Vector3D(-1.5e11, 0.0, 0.0), ldem4.Grid, ldem4.Summary);

        TileChoice middle = selection.All.Single(choice => choice.Tile == new TileId(0, 0));
        Assert.Equal(TileReason.Night, middle.Reason);
        Assert.Equal("night", middle.ReasonText);
    }

    [RequiresFact(Part.Ldem4)]
    public void Select_OnThePolarAxis_KeepsAllTilesAroundThePole()
    {
        PinholeCamera camera = new(
            new Vector3D(0.0, 0.0, 1.9e6), CameraCases.Attitude(-Vector3D.UnitZ, Vector3D.UnitX), 0.5, 64, 64);

        TileSelection selection = Dspsa.Select(camera, null, ldem4.Grid, ldem4.Summary);

        Assert.Equal(TileId.Columns, selection.Kept.Count(choice => choice.Tile.SouthDegrees == 85));
    }

    [RequiresFact(Part.Ldem4)]
    public void Select_CameraInsideTheMoon_IsBadInput()
    {
        PinholeCamera camera = new(new Vector3D(1.7e6, 0.0, 0.0), UnitQuaternion.Identity, 0.5, 64, 64);

        BadInputException exception = Assert.Throws<BadInputException>(() => Dspsa.Select(camera, null, ldem4.Grid, ldem4.Summary));

        Assert.Contains("inside the Moon", exception.Message, StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4)]
    public void Select_SunInsideTheMoon_IsBadInput()
    {
        PinholeCamera camera = new(new Vector3D(4e6, 0.0, 0.0), UnitQuaternion.Identity, 0.5, 64, 64);

        Assert.Throws<BadInputException>(() => Dspsa.Select(camera, new Vector3D(1e6, 0.0, 0.0), ldem4.Grid, ldem4.Summary));
    }

    /// <summary>The model with more samples a degree, between which it is straight, and some noise.</summary>
    private static MemoryElevationGrid Refined(MemoryElevationGrid grid, int factor)
    {
        int lines = 180 * grid.PixelsPerDegree;
        double[][] rows = [.. Enumerable.Range(0, lines).Select(line =>
        {
            double[] row = new double[2 * lines];
            grid.ReadRadii(line, 0, row);
            return row;
        })];
        return new MemoryElevationGrid("LDEM_FINE", factor * grid.PixelsPerDegree, (line, sample) =>
        {
            (double[] north, double[] south) = (rows[line / factor], rows[Math.Min((line / factor) + 1, lines - 1)]);
            (int west, int east) = (sample / factor, ((sample / factor) + 1) % (2 * lines));
            double down = line % factor / (double)factor;
            double right = sample % factor / (double)factor;
            double noise = ((uint)(((line * 7919) + sample) * 2654435761L) >> 16) % 64;
            return Math.Round(((1.0 - down) * (((1.0 - right) * north[west]) + (right * north[east])))
                + (down * (((1.0 - right) * south[west]) + (right * south[east]))) + noise);
        });
    }
}
