namespace Msisf.App.Settings;

/// <summary>Into which pieces a run is cut.</summary>
/// <param name="Pieces">How many; null if the number of frames is given.</param>
/// <param name="FramesPerPiece">Frames of each but the last; null if the number of pieces is given.</param>
internal sealed record CutSettings(int? Pieces, int? FramesPerPiece);
