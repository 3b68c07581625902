namespace Msisf.Benchmarks.Measures;

/// <summary>The ways of sampling whose further frames a child process is to measure.</summary>
/// <param name="Scene">Name of the scene.</param>
/// <param name="Label">Of its model.</param>
/// <param name="Samples">Values of --samples.</param>
/// <param name="WarmUpFrames">Frames of each way that are not measured.</param>
/// <param name="Frames">Frames of each way that are.</param>
internal sealed record SampledFramesJob(string Scene, string Label, IReadOnlyList<string> Samples, int WarmUpFrames, int Frames)
{
    /// <summary>The command word for which this program does such a job.</summary>
    public const string Command = "sampled-frames";
}
