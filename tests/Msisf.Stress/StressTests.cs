using Msisf.Stress.Attitude;
using Msisf.Stress.Camera;
using Msisf.Stress.Cluster;
using Msisf.Stress.Engines;
using Msisf.Stress.Fuzz;
using Msisf.Stress.Metadata;
using Msisf.Stress.Orbit;
using Msisf.Stress.Povray;
using Msisf.Stress.Preview;
using Msisf.Stress.Reference;
using Msisf.Stress.Selection;
using Msisf.Stress.Time;

namespace Msisf.Stress;

/// <summary>All stress tests.</summary>
public static class StressTests
{
    /// <summary>Of all random inputs.</summary>
    public const int Seed = 20120615;

    /// <summary>In the order of the report.</summary>
    public static IReadOnlyList<IStressTest> All { get; } =
    [
        new ReferenceStress(),
        new KeplerStress(),
        new ElementsStress(),
        new StatesStress(),
        new PropagationStress(),
        new AttitudeStress(),
        new TimeStress(),
        new CoverStress(),
        new EnginesStress(),
        new EphemerisStress(),
        new PatternWriterStress(),
        new RendererStress(),
        new TracePrecisionStress(),
        new CameraStress(),
        new PreviewStress(),
        new CoordinatesStress(),
        new SelectionStress(),
        new FuzzStress(),
        new PiecesStress(),
        new KillStress(),
        new SlurmKillStress(),
        new StorageStress(),
        new CrowdStress(),
        new LongSeriesStress(),
    ];
}
