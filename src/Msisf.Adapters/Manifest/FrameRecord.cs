namespace Msisf.Adapters.Manifest;

/// <summary>A frame that was made.</summary>
/// <param name="Step">From 1.</param>
/// <param name="Name">File name of its outputs, without extension.</param>
/// <param name="Frame">Key of the frame: of its settings and its state.</param>
/// <param name="Settings">Key of its settings.</param>
/// <param name="Files">Its files, in the order in which they are named to the user.</param>
public sealed record FrameRecord(int Step, string Name, string Frame, string Settings, IReadOnlyList<OutputFile> Files) : ManifestRecord;
