using Msisf.Core.Detector.Psf;

namespace Msisf.Core.Detector;

/// <summary>The optics' throughput and the detector of a camera (docs/detector.md). Immutable.</summary>
public sealed record DetectorSettings
{
    /// <summary>m^2: area of the aperture.</summary>
    public required double ApertureArea { get; init; }

    /// <summary>Wavelengths, transmission and quantum efficiency.</summary>
    public required Band Band { get; init; }

    /// <summary>Seconds.</summary>
    public required double ExposureTime { get; init; }

    /// <summary>When the rows are exposed; null for images without the camera's motion.</summary>
    public Shutter? Shutter { get; init; }

    /// <summary>Whether all pixels take as much light as the one on the axis: the image of an ideal flat-field correction.</summary>
    public bool IsFlatFielded { get; init; }

    /// <summary>How the image of a point spreads; null if it stays within its pixel.</summary>
    public PointSpreadKernel? PointSpread { get; init; }

    /// <summary>PRNU: standard deviation of the pixels' responses over their mean, 0 to 0.2.</summary>
    public double ResponseNonuniformity { get; init; }

    /// <summary>Dark current, hot pixels.</summary>
    public DarkCurrent Dark { get; init; } = new();

    /// <summary>Part of the pixels that are dead, chosen by the seed, 0 to 1.</summary>
    public double DeadFraction { get; init; }

    /// <summary>Dead pixels that are known.</summary>
    public IReadOnlyList<DeadPixel> DeadPixels { get; init; } = [];

    /// <summary>Light during the transfer of the frame; null if there is none.</summary>
    public Smear? Smear { get; init; }

    /// <summary>Cosmic rays; null if there are none.</summary>
    public CosmicRays? CosmicRays { get; init; }

    /// <summary>m: side of a pixel; only the rate of the cosmic rays depends on it.</summary>
    public double PixelPitch { get; init; }

    /// <summary>Electrons that a pixel holds; infinity if the analogue-to-digital converter alone limits it.</summary>
    public double FullWell { get; init; } = double.PositiveInfinity;

    /// <summary>Whether electrons beyond the full well flow into the pixels above and below; otherwise they are drained.</summary>
    public bool IsBlooming { get; init; }

    /// <summary>Electrons: standard deviation of the read noise.</summary>
    public double ReadNoise { get; init; }

    /// <summary>Electrons per digital number.</summary>
    public required double Gain { get; init; }

    /// <summary>DN of a pixel without electrons.</summary>
    public double Bias { get; init; }

    /// <summary>DN: standard deviation of the columns' offsets.</summary>
    public double ColumnOffset { get; init; }

    /// <summary>Bits of the analogue-to-digital converter, 1 to 16.</summary>
    public required int ConverterBits { get; init; }

    /// <summary>
    /// Seed of the fixed pattern, and of the noise of frames without a <see cref="Scene.NoiseSeed"/>; null for no random fixed pattern, and
    /// no noise in such frames.
    /// </summary>
    public ulong? Seed { get; init; }

    /// <summary>The highest DN.</summary>
    public int MaxNumber => (1 << ConverterBits) - 1;
}
