using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Surface;
using Msisf.Core.Tiles;

namespace Msisf.Core.Metadata;

/// <summary>The terrain point that a pixel shows.</summary>
/// <param name="Height">m over the reference radius.</param>
/// <param name="PositionMoonMe">m, MOON_ME.</param>
/// <param name="Range">m from the camera.</param>
/// <param name="NormalMoonMe">Outward normal that shades the point, MOON_ME, length 1.</param>
/// <param name="Angles">Incidence and emission from this normal, phase.</param>
/// <param name="Light">How the point is lit.</param>
/// <param name="Tile">The tile that holds the facet; null on a map that has no tiles.</param>
/// <param name="Facet">The facet on which the point lies.</param>
public readonly record struct TerrainRecord(
    double Height,
    Vector3D PositionMoonMe,
    double Range,
    Vector3D NormalMoonMe,
    PhotometricAngles Angles,
    PixelIllumination Light,
    TileId? Tile,
    FacetId Facet)
{
    /// <summary>Whether the terrain has several models, and the facet's part says which.</summary>
    public bool NamesPart { get; init; }
}
