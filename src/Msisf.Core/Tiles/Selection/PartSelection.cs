namespace Msisf.Core.Tiles.Selection;

/// <summary>The pieces of surface that an image needs, each at a level of detail.</summary>
/// <param name="Tiles">The tiles from which they were taken.</param>
/// <param name="Parts">
/// By tile, then fineness, then place; they do not overlap, except for the additional rings of cells of coarser levels.
/// </param>
public sealed record PartSelection(TileSelection Tiles, IReadOnlyList<SurfacePart> Parts);
