namespace Msisf.Adapters.Manifest;

/// <summary>What frames were made with: arguments, versions, checksums of model and kernels.</summary>
/// <param name="Key">Names these settings; the same on every computer.</param>
/// <param name="Description">A JSON object.</param>
public sealed record SettingsRecord(string Key, string Description) : ManifestRecord;
