namespace Msisf.Benchmarks.Measures;

/// <summary>A whole run.</summary>
/// <param name="Machine">On what and how.</param>
/// <param name="Scenes">The scenes, in their order.</param>
/// <param name="Sequence">Null if it was not asked for.</param>
/// <param name="Layers">As the sequence, with all layers.</param>
internal sealed record BenchmarkResult(
    string Machine, IReadOnlyList<SceneResult> Scenes, SequenceResult? Sequence, SequenceResult? Layers);
