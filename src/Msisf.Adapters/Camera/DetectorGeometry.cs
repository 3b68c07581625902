namespace Msisf.Adapters.Camera;

/// <summary>What the section of the detector needs to know of the rest of a camera file.</summary>
/// <param name="Path">Path of the file; a kernel's path is relative to its folder.</param>
/// <param name="Width">px.</param>
/// <param name="Height">px.</param>
/// <param name="FocalLength">m; null if the file does not give it in mm.</param>
/// <param name="PixelPitch">m; null if the file does not give it.</param>
/// <param name="MayNameFiles">Whether the file may name another one, the PSF's kernel.</param>
internal sealed record DetectorGeometry(
    string Path, int Width, int Height, double? FocalLength, (double X, double Y)? PixelPitch, bool MayNameFiles = true);
