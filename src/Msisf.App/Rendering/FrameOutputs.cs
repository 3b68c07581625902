namespace Msisf.App.Rendering;

/// <summary>The files of one finished frame.</summary>
/// <param name="Paths">Paths of the files, in the order in which they are shown to the user.</param>
/// <param name="TileCount">Number of patterns that the scene includes.</param>
/// <param name="PatternsMade">Number of patterns that were made for the frame.</param>
/// <param name="WasThere">Whether the frame was already complete, or another process made it.</param>
internal sealed record FrameOutputs(IReadOnlyList<string> Paths, int TileCount, int PatternsMade, bool WasThere = false);
