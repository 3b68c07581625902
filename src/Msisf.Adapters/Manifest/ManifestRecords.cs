namespace Msisf.Adapters.Manifest;

/// <summary>One line of a manifest (docs/formats.md).</summary>
public abstract record ManifestRecord;

/// <summary>What frames were made with: arguments, versions, checksums of model and kernels.</summary>
/// <param name="Key">Names these settings; the same on every computer.</param>
/// <param name="Description">A JSON object.</param>
public sealed record SettingsRecord(string Key, string Description) : ManifestRecord;

/// <summary>A run whose frames the folder is to hold; they follow as <see cref="ExpectedRecord"/>s.</summary>
/// <param name="Run">Names the run: the same frames with the same settings are the same run, in one piece or in many.</param>
/// <param name="Settings">Key of its settings.</param>
/// <param name="Frames">How many frames it has.</param>
public sealed record RunRecord(string Run, string Settings, int Frames) : ManifestRecord;

/// <summary>A frame that a run expects.</summary>
/// <param name="Step">From 1.</param>
/// <param name="Name">File name of its outputs, without extension.</param>
/// <param name="Frame">Key of the frame: of its settings and its state.</param>
public sealed record ExpectedRecord(string Run, int Step, string Name, string Frame) : ManifestRecord;

/// <summary>A frame that was made.</summary>
/// <param name="Step">From 1.</param>
/// <param name="Name">File name of its outputs, without extension.</param>
/// <param name="Frame">Key of the frame: of its settings and its state.</param>
/// <param name="Settings">Key of its settings.</param>
/// <param name="Files">Its files, in the order in which they are named to the user.</param>
public sealed record FrameRecord(int Step, string Name, string Frame, string Settings, IReadOnlyList<OutputFile> Files) : ManifestRecord;

/// <summary>One file of a finished frame.</summary>
/// <param name="Name">Without folder.</param>
/// <param name="Bytes">Its length.</param>
/// <param name="Sha256">SHA-256 of its content, 64 hexadecimal digits in small letters.</param>
public sealed record OutputFile(string Name, long Bytes, string Sha256);

/// <summary>A file that belongs to all frames of the folder, as the index of a data set.</summary>
public sealed record SharedFileRecord(OutputFile File) : ManifestRecord;

/// <summary>A frame that could not be made.</summary>
/// <param name="Step">From 1.</param>
/// <param name="Name">File name of its outputs, without extension.</param>
/// <param name="Frame">Key of the frame.</param>
/// <param name="Cause">Why.</param>
public sealed record FailedRecord(int Step, string Name, string Frame, string Cause) : ManifestRecord;
