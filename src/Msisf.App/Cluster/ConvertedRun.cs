namespace Msisf.App.Cluster;

/// <summary>A run that was converted to a script.</summary>
/// <param name="Script">Full path of the script.</param>
/// <param name="StatesFile">
/// Full path of the states file that was written beside the script; null if the run has a batch file of its own.
/// </param>
/// <param name="OutputFolder">Folder of the frames.</param>
/// <param name="FrameCount">Number of frames in all pieces.</param>
/// <param name="PieceCount">Number of pieces.</param>
internal sealed record ConvertedRun(string Script, string? StatesFile, string OutputFolder, int FrameCount, int PieceCount);
