namespace Msisf.Stress.Metadata;

/// <summary>Random pixels of random cameras: the coordinates and the illumination direction that the meta file gives them.</summary>
public sealed class CoordinatesStress : IStressTest
{
    /// <inheritdoc/>
    public string Name => "coordinates";

    /// <inheritdoc/>
    public string Subject =>
        "Random pixels of random cameras from 1 m to 1e12 m above the reference sphere, the Sun anywhere, near the zenith, "
            + "the nadir and the horizon of "
        + "the pixel's point, or at the camera: latitude, longitude and illumination direction as they stand in the meta file, "
        + "against some 30 digits.";

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        int pixels = length == StressLength.Full ? 1_000_000 : 20_000;
        CoordinatesMeasure measure = SeededCases.Run(pixels, seed + 10, () => new CoordinatesMeasure());
        return new StressReport(Name, pixels, [.. measure.Figures], [.. measure.Series]);
    }
}
