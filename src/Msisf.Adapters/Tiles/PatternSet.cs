namespace Msisf.Adapters.Tiles;

/// <summary>The patterns of a set of tiles, all present.</summary>
/// <param name="Paths">Their files, by latitude, then longitude.</param>
/// <param name="Written">How many were made now; the others were there already.</param>
public sealed record PatternSet(IReadOnlyList<string> Paths, int Written);
