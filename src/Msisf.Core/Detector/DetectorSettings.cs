using Msisf.Core.Detector.Psf;

namespace Msisf.Core.Detector;

/// <summary>The optics' throughput and the detector of a camera (docs/detector.md). Immutable.</summary>
public sealed record DetectorSettings
{
    /// <summary>m^2: area of the aperture.</summary>
    public required double ApertureArea { get; init; }

    /// <summary>Wavelengths, transmission and quantum efficiency.</summary>
    public required SpectralResponse Response { get; init; }

    /// <summary>Seconds.</summary>
    public required double ExposureTime { get; init; }

    /// <summary>These settings with another exposure time.</summary>
    /// <param name="factor">By how much longer; null for as long.</param>
    public DetectorSettings Exposed(double? factor) => factor is { } times ? this with { ExposureTime = times * ExposureTime } : this;

    /// <summary>When the rows are exposed; null for images without the camera's motion.</summary>
    public Shutter? Shutter { get; init; }

    /// <summary>Whether all pixels take as much light as the one on the axis: the image of an ideal flat-field correction.</summary>
    public bool IsFlatFielded { get; init; }

    /// <summary>How the image of a point spreads; null if it stays within its pixel.</summary>
    public PointSpreadKernel? PointSpread { get; init; }

    /// <summary>Stray light over the whole image; null for none.</summary>
    public FarWings? FarWings { get; init; }

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

/// <summary>Charged particles that leave electrons along straight lines through the detector. Immutable.</summary>
public sealed record CosmicRays
{
    /// <summary>Hits per cm^2 and second; in free space some 5 (solar minimum).</summary>
    public required double Rate { get; init; }

    /// <summary>Micrometres: thickness of the layer whose electrons are collected.</summary>
    public double Thickness { get; init; } = 10.0;

    /// <summary>Electrons per micrometre of the path in silicon: 80 for a particle of minimum ionisation.</summary>
    public double ElectronsPerMicrometre { get; init; } = 80.0;
}

/// <summary>
/// When the rows of a detector are exposed, for images with the camera's motion. The frame's time is the middle of the exposure, of a
/// rolling shutter that of its middle row. Immutable.
/// </summary>
public sealed record Shutter
{
    /// <summary>px: the default of <see cref="MaxStep"/>.</summary>
    public const double DefaultMaxStep = 0.25;

    /// <summary>Seconds from the exposure of a row to that of the row below; 0 for a global shutter.</summary>
    public double LineTime { get; init; }

    /// <summary>Whether the rows are exposed one after another.</summary>
    public bool IsRolling => LineTime > 0.0;

    /// <summary>px: how far the image may move from one sub-exposure to the next.</summary>
    public double MaxStep { get; init; } = DefaultMaxStep;

    /// <summary>Seconds from the start of the first row's exposure to the end of the last row's.</summary>
    /// <param name="exposureTime">s, of one row.</param>
    /// <param name="height">px.</param>
    public double Span(double exposureTime, int height) => exposureTime + (LineTime * (height - 1));
}

/// <summary>Light that falls on the rows while a frame-transfer detector shifts them. Immutable.</summary>
public sealed record Smear
{
    /// <summary>Seconds in which a row is shifted by one row.</summary>
    public required double RowTime { get; init; }

    /// <summary>Whether the image is shifted towards its lower border; otherwise to the upper one.</summary>
    public bool TowardsBottom { get; init; } = true;

    /// <summary>
    /// Whether the rows were shifted in light before the exposure too, at the same speed, so that each row has passed all others.
    /// </summary>
    public bool BeforeExposure { get; init; } = true;
}
