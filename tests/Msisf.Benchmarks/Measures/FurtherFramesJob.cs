namespace Msisf.Benchmarks.Measures;

/// <summary>What a child process is to measure.</summary>
internal sealed record FurtherFramesJob(string Scene, string Label, int Threads, int WarmUpFrames, int Frames, int CheckedPixels)
{
    /// <summary>The command word for which this program does such a job.</summary>
    public const string Command = "further-frames";
}
