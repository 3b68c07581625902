namespace Msisf.Adapters.Raster.Albedo;

/// <summary>A tile with its place in the map.</summary>
/// <param name="Label">The tile's label.</param>
/// <param name="Column">The map's column of the tile's first one.</param>
/// <param name="Row">The map's row of the tile's first one.</param>
internal sealed record PlacedMapTile(PdsMapLabel Label, int Column, int Row);
