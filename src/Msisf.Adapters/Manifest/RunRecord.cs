namespace Msisf.Adapters.Manifest;

/// <summary>A run that the folder is to hold; its frames follow as <see cref="ExpectedRecord"/>s.</summary>
/// <param name="Run">Names the run: the same frames with the same settings are the same run, in one piece or in many.</param>
/// <param name="Settings">Key of its settings.</param>
/// <param name="Frames">How many frames it has.</param>
public sealed record RunRecord(string Run, string Settings, int Frames) : ManifestRecord;
