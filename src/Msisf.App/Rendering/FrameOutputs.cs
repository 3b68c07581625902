namespace Msisf.App.Rendering;

/// <summary>The files of one finished frame.</summary>
/// <param name="Paths">In the order in which they are named to the user.</param>
/// <param name="TileCount">Patterns that the scene includes.</param>
/// <param name="PatternsMade">Patterns that were made for it.</param>
/// <param name="WasThere">It was complete already, or another process made it.</param>
internal sealed record FrameOutputs(IReadOnlyList<string> Paths, int TileCount, int PatternsMade, bool WasThere = false);
