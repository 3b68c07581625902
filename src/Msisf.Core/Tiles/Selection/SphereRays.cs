using Msisf.Core.Camera;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.Core.Tiles.Selection;

/// <summary>
/// The thesis's selection (listings 8.1 and 8.2): one ray per pixel against the reference sphere, and the tile of each hit. A sphere has
/// no relief at its limb and throws no shadows (section 8.4); <see cref="Dspsa"/> finds the tiles that this misses.
/// </summary>
public static class SphereRays
{
    /// <summary>The tiles that the rays of an image hit, by day and night alike.</summary>
    public static IReadOnlySet<TileId> TilesOf(ICamera camera)
    {
        HashSet<TileId> tiles = [];
        for (int y = 1; y <= camera.Height; y++)
        {
            for (int x = 1; x <= camera.Width; x++)
            {
                if (ReferenceSphere.Lola.TryFirstHit(camera.RayThrough(x, y), out Vector3D hitBodyFixed))
                {
                    tiles.Add(TileId.Containing(SelenographicPoint.Below(hitBodyFixed)));
                }
            }
        }

        return tiles;
    }
}
