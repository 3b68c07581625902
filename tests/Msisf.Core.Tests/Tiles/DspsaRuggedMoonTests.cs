using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tiles;
using Xunit;

namespace Msisf.Core.Tests.Tiles;

public sealed class DspsaRuggedMoonTests(RuggedMoon rugged) : IClassFixture<RuggedMoon>
{
    /// <summary>Among these, 113, 144 and 187 show something behind a dark tile if that tile is dropped.</summary>
    [Fact]
    public void Select_RuggedMoonWithSun_EveryPixelIsAsWithAllTiles()
    {
        List<string> wrong = [];
        for (int number = 108; number < 192; number++)
        {
            (PinholeCamera camera, Vector3D sun, string kind) = CameraCases.Make(number, rugged.Grid, 1000);
            BruteForcePicture whole = new(rugged.Moon, camera, sun, isThere: null);
            BruteForcePicture selected = new(rugged.Moon, camera, sun, TilesThere.In(Dspsa.Select(camera, sun, rugged.Grid, rugged.Summary)));
            bool[] withoutSun = TilesThere.In(Dspsa.Select(camera, null, rugged.Grid, rugged.Summary));
            bool isAllThere = whole.HitTiles.Zip(withoutSun).All(tile => !tile.First || tile.Second);
            if (whole.DifferencesFrom(selected) > 0 || !isAllThere)
            {
                wrong.Add($"camera {number} ({kind}): {whole.DifferencesFrom(selected)} pixels, all that is hit is there: {isAllThere}");
            }
        }

        Assert.Empty(wrong);
    }
}
