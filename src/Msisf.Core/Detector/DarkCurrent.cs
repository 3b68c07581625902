namespace Msisf.Core.Detector;

/// <summary>Dark current and how it differs from pixel to pixel. Immutable.</summary>
public sealed record DarkCurrent
{
    /// <summary>Electrons per second and pixel at <see cref="ReferenceTemperature"/>.</summary>
    public double Rate { get; init; }

    /// <summary>Degrees Celsius at which <see cref="Rate"/> holds.</summary>
    public double ReferenceTemperature { get; init; } = 20.0;

    /// <summary>Degrees Celsius of the detector.</summary>
    public double Temperature { get; init; } = 20.0;

    /// <summary>K by which the temperature rises when the dark current doubles.</summary>
    public double DoublingTemperature { get; init; } = 6.5;

    /// <summary>DSNU: standard deviation of the pixels' dark currents over their mean. Their distribution is log-normal.</summary>
    public double Nonuniformity { get; init; }

    /// <summary>Part of the pixels that are hot, chosen by the seed, 0 to 1.</summary>
    public double HotFraction { get; init; }

    /// <summary>Electrons per second of the pixels that the seed makes hot, at the reference temperature.</summary>
    public double HotRate { get; init; }

    /// <summary>Hot pixels that are known.</summary>
    public IReadOnlyList<HotPixel> HotPixels { get; init; } = [];

    /// <summary>Dark current at the detector's temperature over that at the reference temperature.</summary>
    public double TemperatureFactor => Math.Pow(2.0, (Temperature - ReferenceTemperature) / DoublingTemperature);
}

/// <summary>A pixel of much dark current.</summary>
/// <param name="X">From 1, to the right.</param>
/// <param name="Y">From 1, down.</param>
/// <param name="Rate">Electrons per second at the reference temperature of the dark current, in place of the other pixels' rate.</param>
public readonly record struct HotPixel(int X, int Y, double Rate);

/// <summary>A pixel that does not respond to light.</summary>
/// <param name="X">From 1, to the right.</param>
/// <param name="Y">From 1, down.</param>
public readonly record struct DeadPixel(int X, int Y);
