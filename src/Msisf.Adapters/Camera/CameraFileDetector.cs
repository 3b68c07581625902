using Msisf.Core.Detector;

namespace Msisf.Adapters.Camera;

/// <summary>What the section "detector" of a camera file says.</summary>
/// <param name="Settings">Optics and detector.</param>
/// <param name="WritesFits">Whether the digital numbers are written as FITS too.</param>
/// <param name="KernelSha256">Checksum of the file of the PSF's kernel, hexadecimal; null if there is none.</param>
public sealed record CameraFileDetector(DetectorSettings Settings, bool WritesFits, string? KernelSha256);
