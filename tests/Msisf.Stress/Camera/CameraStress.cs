namespace Msisf.Stress.Camera;

/// <summary>Rays of single pixels of cameras of all kinds: their directions, and what they meet.</summary>
public sealed class CameraStress : IStressTest
{
    /// <inheritdoc/>
    public string Name => "camera";

    /// <inheritdoc/>
    public string Subject =>
        "Single pixels of cameras from 1 m above the ground to 1e12 m, fields of view from 1e-4 to 179.9 degrees, "
            + "1 x 1 to 16384 x 16384 px, "
        + "aspect up to 1:1000; on the polar axis and beside it, on tile corners, in valleys under the reference sphere, "
        + "rays that graze the limb: "
        + "ray, hit point on the reference sphere and on the terrain, against some 30 digits.";

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        bool isFull = length == StressLength.Full;
        (int rays, int hits, int traces) = isFull ? (1_000_000, 2_000_000, 500_000) : (10_000, 20_000, 5_000);
        TerrainUnderTest terrain = new(JudgedMoon.Real);
        RayMeasure ray = SeededCases.Run(rays, seed, () => new RayMeasure());
        SphereMeasure sphere = SeededCases.Run(hits, seed + 1, () => new SphereMeasure());
        TerrainMeasure trace = SeededCases.Run(traces, seed + 2, () => new TerrainMeasure(terrain));
        BorderCases border = new(terrain);
        return new StressReport(
            Name,
            rays + hits + traces + border.Count,
            [.. ray.Figures, .. sphere.Figures, .. trace.Figures, .. border.Figures()],
            [.. ray.Series, .. sphere.Series, .. trace.Series]);
    }
}
