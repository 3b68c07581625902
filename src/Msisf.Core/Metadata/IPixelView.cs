using Msisf.Core.Terrain;

namespace Msisf.Core.Metadata;

/// <summary>What single pixels of a frame show. Safe for several threads.</summary>
internal interface IPixelView
{
    /// <summary>The surface on which the points lie.</summary>
    PixelSurface Surface { get; }

    /// <summary>The record of a pixel.</summary>
    /// <param name="h">The pixel's x, from 1, to the right.</param>
    /// <param name="v">The pixel's y, from 1, down.</param>
    /// <param name="record">What it shows; <c>default</c> if it does not show the Moon.</param>
    /// <returns>Whether it shows the Moon.</returns>
    bool TryGet(int h, int v, out PixelRecord record);
}

/// <summary>The surface on which the points of a meta file's pixels lie.</summary>
public enum PixelSurface
{
    /// <summary>The reference sphere of thesis section 9.3.</summary>
    Sphere,

    /// <summary>The facets that the image shows.</summary>
    Terrain,
}

/// <summary>What one pixel of the grid shows (thesis section 9.3).</summary>
/// <param name="H">The pixel's x, from 1, to the right.</param>
/// <param name="V">The pixel's y, from 1, down.</param>
/// <param name="Point">The point of the reference sphere on the pixel's ray; for terrain, the place of the terrain point.</param>
/// <param name="IlluminationDirection">
/// rad, [0, 2 pi), see <see cref="Metadata.IlluminationDirection"/>; null where it is undefined.
/// </param>
/// <param name="Terrain">The terrain point; null on the reference sphere.</param>
public readonly record struct PixelRecord(
    int H, int V, SelenographicPoint Point, double? IlluminationDirection, TerrainRecord? Terrain = null);
