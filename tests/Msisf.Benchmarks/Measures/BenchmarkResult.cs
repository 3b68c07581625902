using Msisf.Benchmarks.Fronts;

namespace Msisf.Benchmarks.Measures;

/// <summary>A whole run.</summary>
/// <param name="Machine">On what and how.</param>
/// <param name="Scenes">The native renderer's frames, scene by scene.</param>
/// <param name="Fronts">Time against error of both renderers, scene by scene.</param>
/// <param name="FromNothing">Null if it was not asked for.</param>
/// <param name="Sequence">Null if it was not asked for.</param>
/// <param name="Layers">As the sequence, with all layers.</param>
/// <param name="Descent">Null if it was not asked for.</param>
/// <param name="Detector">Null if it was not asked for.</param>
internal sealed record BenchmarkResult(
    string Machine,
    IReadOnlyList<SceneResult> Scenes,
    IReadOnlyList<SceneFront> Fronts,
    FromNothingResult? FromNothing,
    SequenceResult? Sequence,
    SequenceResult? Layers,
    SequenceResult? Descent,
    DetectorResult? Detector);
