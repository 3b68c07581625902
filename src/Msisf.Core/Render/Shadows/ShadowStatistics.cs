namespace Msisf.Core.Render.Shadows;

/// <summary>What the shadows of a frame took; the same for the same frame, whatever the number of threads.</summary>
/// <param name="Receivers">Points that were looked at; those deep in the night are not counted.</param>
/// <param name="Groups">Groups of blocks that bounds could not rule out.</param>
/// <param name="Blocks">Blocks that were read cell by cell.</param>
/// <param name="Facets">Facets that face away from the Sun and may have a receiver behind them.</param>
/// <param name="Tries">Vectors of eight receivers that facets were tried against.</param>
internal readonly record struct ShadowStatistics(int Receivers, int Groups, int Blocks, int Facets, long Tries);
