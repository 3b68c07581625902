using Msisf.Benchmarks.Definitions;

namespace Msisf.Benchmarks.Measures;

/// <summary>What the native renderer's frames of a scene cost.</summary>
/// <param name="Scene">The scene.</param>
/// <param name="Targets">Its targets.</param>
/// <param name="First">Processes of one frame.</param>
/// <param name="Further">Further frames; the first setting is the program's default: all threads, the widest vectors.</param>
/// <param name="Sampled">Further frames with several samples a pixel; none where they are not measured.</param>
internal sealed record SceneResult(
    Scene Scene, SceneTargets Targets, FirstFrameResult First, IReadOnlyList<FurtherFramesResult> Further,
    IReadOnlyList<SampledFramesResult> Sampled)
{
    public Samples DefaultFurtherSeconds => new(Further[0].FrameSeconds);
}
