namespace Msisf.App.Cluster;

/// <summary>A run as a script.</summary>
/// <param name="Script">Full path.</param>
/// <param name="StatesFile">Full path of the states that were written beside it; null if the run has a file of its own.</param>
/// <param name="OutputFolder">Of the frames.</param>
/// <param name="FrameCount">Frames of all pieces.</param>
/// <param name="PieceCount">Pieces.</param>
internal sealed record ConvertedRun(string Script, string? StatesFile, string OutputFolder, int FrameCount, int PieceCount);
