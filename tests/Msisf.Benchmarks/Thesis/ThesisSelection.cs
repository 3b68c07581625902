using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;
using Msisf.Core.Tracing;

namespace Msisf.Benchmarks.Thesis;

/// <summary>
/// The thesis's selection (chapter 8): a ray for each pixel is shot at the sphere, and the tiles of the points that are met are taken, by
/// day and night alike. The radius is that of its published example (docs/deviations.md, row 8).
/// </summary>
internal static class ThesisSelection
{
    /// <summary>The tiles, by latitude, then longitude.</summary>
    public static IReadOnlyList<TileId> Select(PinholeCamera camera)
    {
        SortedSet<TileId> tiles = [];
        TileId last = default;
        for (int y = 1; y <= camera.Height; y++)
        {
            for (int x = 1; x <= camera.Width; x++)
            {
                // Neighbours mostly meet the same tile; looking it up again would be most of the time.
                if (TryMeet(camera.RayThrough(x, y), out TileId tile) && (tile != last || tiles.Count == 0))
                {
                    tiles.Add(tile);
                    last = tile;
                }
            }
        }

        return [.. tiles];
    }

    private static bool TryMeet(Ray ray, out TileId tile)
    {
        bool isMet = ReferenceSphere.Lola.TryFirstHit(ray, out Vector3D point);
        tile = isMet ? Holding(SelenographicPoint.Below(point)) : default;
        return isMet;
    }

    /// <summary>Latitude 90 and longitude 360 degrees belong to the last row and the first column (docs/deviations.md, row 12).</summary>
    private static TileId Holding(SelenographicPoint point)
    {
        int row = (int)((double.RadiansToDegrees(point.Latitude) + 90.0) / TileId.SizeDegrees);
        int column = (int)(double.RadiansToDegrees(point.Longitude) / TileId.SizeDegrees);
        return new TileId((Math.Min(row, TileId.Rows - 1) * TileId.SizeDegrees) - 90, column % TileId.Columns * TileId.SizeDegrees);
    }
}
