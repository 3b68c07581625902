using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Programs;

namespace Msisf.Benchmarks.Measures;

/// <summary>What a sequence costs.</summary>
internal sealed class SequenceResult
{
    private const int FewestFrames = 5;

    private readonly ProgramRun _run;
    private readonly double[] _doneAt;

    /// <summary>Takes a run.</summary>
    /// <param name="frames">Frames that were asked for.</param>
    /// <param name="run">The run; it names each image when it and all before it are done.</param>
    /// <param name="bytes">Bytes of all files.</param>
    /// <exception cref="BenchmarkException">Not all frames are there.</exception>
    public SequenceResult(int frames, ProgramRun run, long bytes)
    {
        _run = run;
        _doneAt = [.. run.Output.Where(line => line.Line.EndsWith(".png", StringComparison.Ordinal)).Select(line => line.Seconds)];
        Bytes = bytes;
        PeakMemoryBytes = RunTiming.Of(run).PeakMemoryBytes;
        if (_doneAt.Length != frames)
        {
            throw new BenchmarkException(FormattableString.Invariant($"the sequence has {_doneAt.Length} images, {frames} expected."));
        }
    }

    public int Frames => _doneAt.Length;

    public long Bytes { get; }

    /// <summary>Of msis, by its own account.</summary>
    public double PeakMemoryBytes { get; }

    /// <summary>From the start of the process to its end.</summary>
    public double FramesPerSecond => Frames / _run.Seconds;

    public double BytesPerSecond => Bytes / _run.Seconds;

    /// <summary>A tenth of the frames: 100 of 1000; of few frames some, because they end in bursts.</summary>
    public int WindowFrames => Math.Max(Frames / 10, Math.Min(FewestFrames, Frames - 1));

    /// <summary>Frames a second of the first window, start-up left out.</summary>
    public double FirstRate => RateFrom(0);

    public double LastRate => RateFrom(Frames - 1 - WindowFrames);

    /// <summary>Of all windows.</summary>
    public double SlowestRate => Enumerable.Range(0, Frames - WindowFrames).Min(RateFrom);

    /// <summary>Memory around the middle of the first window, after 50 of 1000 frames; null if the run was too short to be seen.</summary>
    public MemorySample? FirstMemory => MedianMemory(_doneAt[WindowFrames / 4], _doneAt[WindowFrames * 3 / 4]);

    public MemorySample? LastMemory => MedianMemory(_doneAt[Frames - 1 - WindowFrames], double.PositiveInfinity);

    private double RateFrom(int frame) => WindowFrames / (_doneAt[frame + WindowFrames] - _doneAt[frame]);

    private MemorySample? MedianMemory(double from, double to)
    {
        MemorySample[] seen = [.. _run.Memory.Where(sample => sample.Seconds >= from && sample.Seconds <= to)];
        return seen.Length == 0 ? null : new MemorySample(
            new Samples(seen.Select(sample => sample.Seconds)).Median,
            (long)new Samples(seen.Select(sample => (double)sample.OwnBytes)).Median,
            (long)new Samples(seen.Select(sample => (double)sample.FileBytes)).Median);
    }
}
