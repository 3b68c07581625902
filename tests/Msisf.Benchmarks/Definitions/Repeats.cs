namespace Msisf.Benchmarks.Definitions;

/// <summary>How often things are measured.</summary>
/// <param name="FirstFrames">Processes of one frame.</param>
/// <param name="Images">Images of each way whose time and error are measured, after the first one, where one takes seconds.</param>
/// <param name="WarmUpFrames">Further frames until the code is compiled for good.</param>
/// <param name="FurtherFrames">Further frames that are measured.</param>
/// <param name="SampledWarmUpFrames">The same of frames with several samples a pixel, which take longer.</param>
/// <param name="SampledFrames">Frames of these that are measured.</param>
/// <param name="CheckedPixels">Pixels that are compared with the exact tracer.</param>
/// <param name="SequenceFrames">Frames of the sequence.</param>
/// <param name="SequencePixelsPerDegree">Resolution of the sequence's model.</param>
/// <param name="LayeredFrames">Frames of the sequence with all layers.</param>
/// <param name="DescentFrames">Frames of the descent.</param>
internal sealed record Repeats(
    int FirstFrames,
    int Images,
    int WarmUpFrames,
    int FurtherFrames,
    int SampledWarmUpFrames,
    int SampledFrames,
    int CheckedPixels,
    int SequenceFrames,
    int SequencePixelsPerDegree,
    int LayeredFrames,
    int DescentFrames)
{
    public static Repeats Full { get; } = new(5, 2, 20, 25, 6, 9, 1000, 1000, 64, 20, 1000);

    /// <summary>Shows that the benchmark works, no more.</summary>
    public static Repeats Quick { get; } = new(3, 0, 5, 5, 1, 2, 100, 20, 4, 2, 20);
}
