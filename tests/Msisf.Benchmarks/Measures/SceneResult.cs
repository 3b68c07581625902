using Msisf.Benchmarks.Definitions;

namespace Msisf.Benchmarks.Measures;

/// <summary>All that was measured of a scene.</summary>
/// <param name="Scene">The scene.</param>
/// <param name="Patterns">Patterns of POV-Ray's picture; null if it was not measured.</param>
/// <param name="First">Processes of one frame.</param>
/// <param name="Further">Further frames; the first setting is the program's usual one: all threads, the widest vectors.</param>
internal sealed record SceneResult(Scene Scene, int? Patterns, FirstFrameResult First, IReadOnlyList<FurtherFramesResult> Further)
{
    public Samples UsualFurtherSeconds => new(Further[0].FrameSeconds);

    /// <summary>How many times as long as a frame POV-Ray's way takes; null if it was not measured.</summary>
    public double? TimesFasterThanPovRay(double frameSeconds) => First.PovRay is Samples povRay ? povRay.Median / frameSeconds : null;
}
