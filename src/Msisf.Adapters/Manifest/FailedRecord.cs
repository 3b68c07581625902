namespace Msisf.Adapters.Manifest;

/// <summary>A frame that could not be made.</summary>
/// <param name="Step">From 1.</param>
/// <param name="Name">File name of its outputs, without extension.</param>
/// <param name="Frame">Key of the frame.</param>
/// <param name="Cause">Why.</param>
public sealed record FailedRecord(int Step, string Name, string Frame, string Cause) : ManifestRecord;
