using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tiles;
using Msisf.Core.Tiles.Selection;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Tiles.Selection;

public sealed class SphereRaysTests(RuggedMoon rugged, Ldem4Fixture ldem4) : IClassFixture<RuggedMoon>, IClassFixture<Ldem4Fixture>
{
    private const int PixelsEach = 4_000;
    private static readonly int Cameras = TestLength.Of(48, 240);

    /// <summary>The listing sees the far side from inside the sphere, so cameras in craters below it are left out.</summary>
    [Fact]
    public void TilesOf_ManyCameras_AreThoseOfListing81()
    {
        int tiles = 0;
        for (int number = 0; number < Cameras; number++)
        {
            (PinholeCamera camera, _, string kind) = CameraCases.Make(number, rugged.Grid, PixelsEach);
            if (camera.PositionBodyFixed.Length > MoonConstants.ReferenceRadius)
            {
                List<string> listed = PatternsOf(camera);
                listed.Remove("_lat_90_95_lon_0_5"); // what the listing makes of a ray that meets the pole: no such tile exists
                tiles += listed.Count;
                HashSet<string> other = [.. SphereRays.TilesOf(camera).Select(tile => $"_{tile.RangeText}")];
                other.SymmetricExceptWith(listed);
                Assert.True(other.Count == 0, $"camera {number} ({kind}): {string.Join(' ', other)}");
            }
        }

        Assert.True(tiles > 20 * Cameras, $"only {tiles} tiles: the cameras show nothing");
    }

    /// <summary>
    /// Why there is more than the thesis's algorithm (section 8.4): rays that hit the real ground in tiles in which no ray hits the sphere.
    /// </summary>
    [RequiresFact(Part.Ldem4)]
    public void TilesOf_RealMoon_MissTilesThatTheSelectionNamesRelief()
    {
        int missed = 0;
        for (int number = 0; number < Cameras; number++)
        {
            (PinholeCamera camera, Vector3D sun, _) = CameraCases.Make(number, ldem4.Grid, 600);
            IReadOnlySet<TileId> hit = SphereRays.TilesOf(camera);
            TileSelection selection = ldem4.Selection.Select(camera, null).WithRays(hit);
            bool[] isSeen = new BruteForceImage(ldem4.Moon, camera, sun, isThere: null).HitTiles;
            TileChoice[] seenBeyondSphere =
                [.. selection.All.Where(choice => isSeen[NumberFromNorth(choice.Tile)] && !hit.Contains(choice.Tile))];
            missed += seenBeyondSphere.Length;

            Assert.All(seenBeyondSphere, choice => Assert.Equal(TileReason.Relief, choice.Reason));
            Assert.All(selection.Kept.Where(choice => hit.Contains(choice.Tile)), choice => Assert.Equal("visible", choice.ReasonText));
        }

        Assert.InRange(missed, 1, TileId.Count);
    }

    private static int NumberFromNorth(TileId tile) => (tile.RowFromNorth * TileId.Columns) + tile.Column;

    /// <summary>Listing 8.2, without rays that lead away from the Moon: the listing takes hits behind the camera.</summary>
    private static List<string> PatternsOf(PinholeCamera camera)
    {
        List<string> patterns = [];
        for (int y = 1; y <= camera.Height; y++)
        {
            for (int x = 1; x <= camera.Width; x++)
            {
                Vector3D direction = DirectionOf(camera, x, y);
                if (Vector3D.Dot(direction, camera.PositionBodyFixed) < 0.0)
                {
                    Dspsa81(direction, camera.PositionBodyFixed, patterns);
                }
            }
        }

        return patterns;
    }

    /// <summary>Equation 8.15, the direction through a pixel.</summary>
    private static Vector3D DirectionOf(PinholeCamera camera, int x, int y) => camera.Direction
        + ((1.0 + camera.Height - (2.0 * y)) / (2.0 * camera.Height) * camera.Up)
        - ((1.0 + camera.Width - (2.0 * x)) / (2.0 * camera.Width) * camera.Right);

    /// <summary>
    /// Listing 8.1, line by line. ERRATA row 8: the radius is that of the published example. Row 12: the lines that print lost for negative
    /// latitudes.
    /// </summary>
    private static void Dspsa81(Vector3D rayDirection, Vector3D camPos, List<string> patternList)
    {
        const double moonRadius = 1_737_400.0;
        double discriminant = (4 * Math.Pow(Vector3D.Dot(camPos, rayDirection), 2))
            - (4 * Vector3D.Dot(rayDirection, rayDirection) * Vector3D.Dot(camPos, camPos))
            + (4 * Vector3D.Dot(rayDirection, rayDirection) * Math.Pow(moonRadius, 2));

        bool encounter = false;
        double lat = 0;
        double lon = 0;
        if (discriminant < 0)
        {
            // no encounter
        }
        else if (discriminant == 0)
        {
            encounter = true;
            double t = -2 * Vector3D.Dot(camPos, rayDirection) / (2 * Vector3D.Dot(rayDirection, rayDirection));
            Vector3D rayPoint = camPos + (t * rayDirection);
            lat = double.RadiansToDegrees((Math.PI / 2) - Math.Acos(rayPoint.Z / moonRadius));
            lon = double.RadiansToDegrees(Math.Atan2(rayPoint.Y, rayPoint.X));
        }
        else
        {
            encounter = true;
            double t1 = ((-2 * Vector3D.Dot(camPos, rayDirection)) + Math.Sqrt(discriminant))
                / (2 * Vector3D.Dot(rayDirection, rayDirection));
            double t2 = ((-2 * Vector3D.Dot(camPos, rayDirection)) - Math.Sqrt(discriminant))
                / (2 * Vector3D.Dot(rayDirection, rayDirection));
            Vector3D rayPoint1 = camPos + (t1 * rayDirection);
            Vector3D rayPoint2 = camPos + (t2 * rayDirection);
            double rayNorm1 = (rayPoint1 - camPos).Length;
            double rayNorm2 = (rayPoint2 - camPos).Length;
            if (rayNorm1 < rayNorm2)
            {
                lat = double.RadiansToDegrees((Math.PI / 2) - Math.Acos(rayPoint1.Z / moonRadius));
                lon = double.RadiansToDegrees(Math.Atan2(rayPoint1.Y, rayPoint1.X));
            }
            else
            {
                lat = double.RadiansToDegrees((Math.PI / 2) - Math.Acos(rayPoint2.Z / moonRadius));
                lon = double.RadiansToDegrees(Math.Atan2(rayPoint2.Y, rayPoint2.X));
            }
        }

        if (lon < 0)
        {
            lon += 360;
        }

        if (encounter)
        {
            double latStart;
            double latEnd;
            if (lat >= 0)
            {
                latStart = Math.Truncate(lat / 5) * 5;
                latEnd = latStart + 5;
            }
            else
            {
                latEnd = (Math.Truncate(lat / 5) * 5) + 0.0; // .NET then wrote -0 as 0
                latStart = latEnd - 5;
            }

            double lonStart = Math.Truncate(lon / 5) * 5;
            double lonEnd = lonStart + 5;
            string temp = FormattableString.Invariant($"_lat_{latStart}_{latEnd}_lon_{lonStart}_{lonEnd}");
            if (!patternList.Contains(temp))
            {
                patternList.Add(temp);
            }
        }
    }
}
