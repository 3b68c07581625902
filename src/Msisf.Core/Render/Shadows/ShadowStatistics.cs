namespace Msisf.Core.Render.Shadows;

/// <summary>Counts of the work that the shadows of a frame took.</summary>
/// <param name="Receivers">Points that were tested; points in the night zone are not counted.</param>
/// <param name="Groups">Groups of blocks that bounds could not rule out.</param>
/// <param name="Blocks">Blocks that were read cell by cell.</param>
/// <param name="Strips">Strips of eight cells with facets that face away from the Sun and may have a receiver behind them.</param>
/// <param name="Tries">Vectors of eight receivers that were tested against a strip or a facet.</param>
internal readonly record struct ShadowStatistics(int Receivers, int Groups, int Blocks, int Strips, long Tries);
