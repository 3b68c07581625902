using Msisf.Core.Camera;
using Msisf.Core.Detector;

namespace Msisf.Adapters.Camera;

/// <summary>What a camera file says.</summary>
/// <param name="Name">Name of the preset, or of the file without folder.</param>
/// <param name="Sha256">Checksum of the file, hexadecimal.</param>
/// <param name="Description">What the camera is; null if the file does not say it.</param>
/// <param name="Model">Size, focal length, principal point and distortion.</param>
/// <param name="FocalLength">m; null if the file gives it in px, or a field of view.</param>
/// <param name="PixelPitch">m, along rows and columns; null if the file gives the focal length in px, or a field of view.</param>
/// <param name="Path">Where the file is.</param>
/// <param name="Bytes">Its length.</param>
/// <param name="IsPreset">Whether it belongs to the installation.</param>
/// <param name="FieldOfViewDegrees">Horizontal field of view, as the file gives it or computed.</param>
/// <param name="Detector">Optics and detector; null if the file does not describe them.</param>
public sealed record CameraFile(
    string Name, string Sha256, string? Description, CameraModel Model, double? FocalLength, (double X, double Y)? PixelPitch, string Path,
    long Bytes, bool IsPreset, double FieldOfViewDegrees, CameraFileDetector? Detector = null)
{
    /// <summary>px: width that the file does not say, but the user; null if the file says it.</summary>
    public int? AddedWidth { get; init; }

    /// <summary>px: height that the file does not say, but the user; null if the file says it.</summary>
    public int? AddedHeight { get; init; }

    /// <summary>How the camera scans; null for one whose images are frames.</summary>
    public CameraFileScan? Scan { get; init; }
}

/// <summary>What the section "detector" of a camera file says.</summary>
/// <param name="Settings">Optics and detector.</param>
/// <param name="WritesFits">Whether the digital numbers are written as FITS too.</param>
/// <param name="KernelSha256">Checksum of the file of the PSF's kernel, hexadecimal; null if there is none.</param>
public sealed record CameraFileDetector(DetectorSettings Settings, bool WritesFits, string? KernelSha256);
