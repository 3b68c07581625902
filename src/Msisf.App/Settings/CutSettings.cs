namespace Msisf.App.Settings;

/// <summary>How a run is cut into pieces.</summary>
/// <param name="Pieces">Number of pieces; null if the number of frames is given.</param>
/// <param name="FramesPerPiece">Frames of each piece except the last; null if the number of pieces is given.</param>
internal sealed record CutSettings(int? Pieces, int? FramesPerPiece);
