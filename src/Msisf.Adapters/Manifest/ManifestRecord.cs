namespace Msisf.Adapters.Manifest;

/// <summary>One line of a manifest (docs/formats.md).</summary>
public abstract record ManifestRecord;
