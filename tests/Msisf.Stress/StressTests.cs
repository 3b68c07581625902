using Msisf.Stress.Camera;
using Msisf.Stress.Metadata;
using Msisf.Stress.Selection;

namespace Msisf.Stress;

/// <summary>All stress tests.</summary>
public static class StressTests
{
    /// <summary>Of all random inputs.</summary>
    public const int Seed = 20120615;

    /// <summary>In the order of the report.</summary>
    public static IReadOnlyList<IStressTest> All { get; } =
    [
        new CameraStress(),
        new CoordinatesStress(),
        new SelectionStress(),
    ];
}
