namespace Msisf.Benchmarks.Measures;

/// <summary>Further frames of a way of sampling.</summary>
/// <param name="Samples">Value of --samples.</param>
/// <param name="FrameSeconds">Each measured frame.</param>
/// <param name="ErrorLevels">Rms error of the last frame against 64 samples in every pixel, levels of 255.</param>
internal sealed record SampledFramesResult(string Samples, IReadOnlyList<double> FrameSeconds, double ErrorLevels);
