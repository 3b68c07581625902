using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tiles;
using Msisf.Core.Tiles.Selection;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Tiles.Selection;

public sealed class DspsaRuggedMoonTests(RuggedMoon rugged) : IClassFixture<RuggedMoon>
{
    /// <summary>
    /// Among the first, 113, 144 and 187 show something behind a dark tile if that tile is dropped; in 101337 a ray to the Sun passes under
    /// a kept ridge, but enters the ground before it, through a tile that throws no other shadow.
    /// </summary>
    [Theory]
    [InlineData(108, 192)]
    [InlineData(101337, 101338)]
    public void Select_RuggedMoonWithSun_EveryPixelIsAsWithAllTiles(int first, int end)
    {
        List<string> wrong = [];
        foreach (int number in Enumerable.Range(first, end - first).Where(IsTried))
        {
            (PinholeCamera camera, Vector3D sun, string kind) = CameraCases.Make(number, rugged.Grid, number > 1000 ? 600 : 1000);
            BruteForceImage whole = new(rugged.Moon, camera, sun, isThere: null);
            BruteForceImage selected = new(rugged.Moon, camera, sun, TilesThere.In(rugged.Selection.Select(camera, sun)));
            bool[] withoutSun = TilesThere.In(rugged.Selection.Select(camera, null));
            bool isAllThere = whole.HitTiles.Zip(withoutSun).All(tile => !tile.First || tile.Second);
            if (whole.DifferencesFrom(selected) > 0 || !isAllThere)
            {
                wrong.Add($"camera {number} ({kind}): {whole.DifferencesFrom(selected)} pixels, all that is hit is there: {isAllThere}");
            }
        }

        Assert.Empty(wrong);
    }

    /// <summary>Every day one camera of each of the twelve kinds, and those that once showed a mistake.</summary>
    private static bool IsTried(int number) => TestLength.IsLong || number is < 120 or 144 or 187 or > 1000;
}
