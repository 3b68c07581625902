namespace Msisf.Adapters.Manifest;

/// <summary>A frame that a run is to have.</summary>
/// <param name="Run">The run.</param>
/// <param name="Step">From 1.</param>
/// <param name="Name">File name of its outputs, without extension.</param>
/// <param name="Frame">Key of the frame: of its settings and its state.</param>
public sealed record ExpectedRecord(string Run, int Step, string Name, string Frame) : ManifestRecord;
