using Msisf.Stress.Engines;
using Msisf.Stress.Orbit;
using Msisf.Stress.Povray;

namespace Msisf.Stress;

/// <summary>All stress tests.</summary>
public static class StressTests
{
    /// <summary>Of all random inputs.</summary>
    public const int Seed = 20120615;

    /// <summary>In the order of the report.</summary>
    public static IReadOnlyList<IStressTest> All { get; } =
    [
        new KeplerStress(),
        new EphemerisStress(),
        new PatternWriterStress(),
        new RendererStress(),
        new TracePrecisionStress(),
    ];
}
