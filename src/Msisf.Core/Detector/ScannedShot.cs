using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.Core.Detector;

/// <summary>A scanned image to be exposed.</summary>
/// <param name="Camera">The camera of the image, with the Sun of each exposure.</param>
/// <param name="Time">Time of the image, UTC; goes into the noise.</param>
/// <param name="Noise">The noise of the image, whatever time and camera are; null for that of the detector's seed.</param>
/// <param name="HalfExposure">s: half of the time that the shutter is open; 0 for images without the camera's motion in it.</param>
public sealed record ScannedShot(
    Scan Scan, CameraModel Model, ScanPath Path, ICamera Camera, SceneLight Light, Instant Time, NoiseSeed? Noise,
    double HalfExposure)
{
    private const ulong GoldenRatio = 0x9E3779B97F4A7C15; // as SplitMix64 steps: exposures of one image have far apart numbers

    /// <summary>The camera whose place counts for the noise; null for that of the first row.</summary>
    public ICamera? NoiseCamera { get; init; }

    /// <summary>Whether the camera moves while the shutter is open.</summary>
    public bool HasShutter => HalfExposure > 0.0;

    /// <summary>The noise of an exposure; null for that of the detector's seed, of time and camera.</summary>
    public NoiseSeed? NoiseOf(int exposure) =>
        Noise is { } seed ? seed with { Number = unchecked(seed.Number + ((ulong)exposure * GoldenRatio)) } : null;
}
