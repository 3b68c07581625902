using System.Collections.Concurrent;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.Core.Scene;

namespace Msisf.App.Rendering;

/// <summary>
/// Makes many frames, several at once, so that the cores are neither idle nor shared by too many threads. A failed frame is recorded, and
/// the other frames are still made. A frame that another process is making is handled last.
/// </summary>
/// <param name="maker">Makes one frame; the renderer itself limits how many frames are drawn at once.</param>
/// <param name="ahead">
/// Number of frames to begin in addition to those that are drawn at once (<see cref="IFrameRenderer.FramesAhead"/>).
/// </param>
/// <param name="failFast">Whether the first failed frame ends the run.</param>
/// <param name="progress">Is told of each frame that is done.</param>
/// <param name="log">Receives the errors of single frames.</param>
internal sealed class FrameLoop(FrameMaker maker, int ahead, bool failFast, FrameProgress progress, TextWriter results, ILog log)
{
    /// <summary>Makes all frames; the paths of a frame's files are printed when those of all earlier frames have been printed.</summary>
    /// <param name="known">For each frame, its outputs if it exists and is complete, or null if it must be made.</param>
    /// <param name="atOnce">Number of frames drawn at once.</param>
    /// <param name="cores">Number of cores, shared by the frames.</param>
    /// <param name="cancellation">Cancels the work; finished frames are kept, and no other file is left.</param>
    /// <exception cref="MsisfException">
    /// The only frame of the run failed, and the exception is its own. If several frames were to be made, it is an
    /// <see cref="ExternalPartException"/> that names the failed ones.
    /// </exception>
    public async Task<IReadOnlyList<FrameOutputs>> RunAsync(
        IReadOnlyList<Frame> frames, IReadOnlyList<FrameOutputs?> known, int atOnce, int cores, CancellationToken cancellation)
    {
        int threads = Math.Max(1, cores / atOnce);
        FrameOutputs?[] outputs = [.. known];
        OrderedPrinter printer = new(results, frames.Count);
        ConcurrentQueue<int> failed = new();
        ConcurrentQueue<int> elsewhere = new();

        async ValueTask Make(int index, Func<Frame, int, CancellationToken, Task<FrameOutputs?>> make, CancellationToken stop)
        {
            Frame frame = frames[index];
            try
            {
                outputs[index] = await make(frame, threads, stop).ConfigureAwait(false);
                if (outputs[index] is null)
                {
                    elsewhere.Enqueue(index);
                    return;
                }
            }
            catch (MsisfException exception) when (frames.Count > 1)
            {
                failed.Enqueue(frame.Step);
                string message = $"step {frame.Step} ({frame.Name}): {exception.Message}";
                if (failFast)
                {
                    throw new ExternalPartException(
                        $"{message} Stopped there, as --fail-fast asks; finished frames are complete.", exception);
                }

                log.Error(message);
            }

            printer.Done(index, outputs[index]?.Paths ?? []);
            progress.Done(frame);
        }

        ParallelOptions options = new()
        {
            MaxDegreeOfParallelism = Math.Min(atOnce + ahead, Math.Max(1, frames.Count)),
            CancellationToken = cancellation,
        };
        int[] missing = [.. Enumerable.Range(0, frames.Count).Where(index => known[index] is null)];
        foreach (int index in Enumerable.Range(0, frames.Count).Except(missing))
        {
            printer.Done(index, known[index]!.Paths);
        }

        await Parallel.ForEachAsync(missing, options, (index, stop) => Make(index, maker.TryMakeAsync, stop)).ConfigureAwait(false);
        await Parallel.ForEachAsync(
            elsewhere.Order().ToArray(),
            options,
            (index, stop) => Make(
                index,
                async (frame, share, end) => await maker.MakeAsync(frame, share, end).ConfigureAwait(false),
                stop)).ConfigureAwait(false);
        return failed.IsEmpty
            ? [.. outputs.OfType<FrameOutputs>()]
            : throw new ExternalPartException(
                $"{failed.Count} of {frames.Count} frames failed: steps {StepRanges.Of(failed.Distinct())}. The others are complete.");
    }
}

/// <summary>
/// Prints the results of steps in the order of the steps, each as early as possible, whatever order they end in. Thread-safe.
/// </summary>
internal sealed class OrderedPrinter(TextWriter results, int steps)
{
    private readonly Lock _gate = new();
    private readonly IReadOnlyList<string>?[] _waiting = new IReadOnlyList<string>?[steps];
    private int _next;

    /// <summary>Reports that a step is done.</summary>
    /// <param name="index">Index of the step, from 0.</param>
    /// <param name="lines">The lines of the step; empty if it failed.</param>
    public void Done(int index, IReadOnlyList<string> lines)
    {
        lock (_gate)
        {
            _waiting[index] = lines;
            while (_next < _waiting.Length && _waiting[_next] is IReadOnlyList<string> ready)
            {
                foreach (string line in ready)
                {
                    results.WriteLine(line);
                }

                _waiting[_next] = [];
                _next++;
            }

            results.Flush();
        }
    }
}

/// <summary>Shows the progress of frames: one step each, or 100 where a single one can take minutes. Thread-safe.</summary>
/// <param name="display">Receives the steps.</param>
/// <param name="isFine">Whether frames have 100 steps.</param>
internal sealed class FrameProgress(IRunProgress display, bool isFine)
{
    private readonly ConcurrentDictionary<(int Step, int Camera), FractionProgress> _drawn = new();

    /// <summary>Steps of a frame.</summary>
    public static int StepsOf(bool isFine) => isFine ? FractionProgress.Steps : 1;

    /// <summary>Takes the part of a frame that is done; null where nobody wants to know it.</summary>
    public IProgress<double>? Of(Frame frame) => isFine ? FractionOf(frame) : null;

    /// <summary>Reports that a frame is done.</summary>
    public void Done(Frame frame)
    {
        if (!isFine)
        {
            display.Advance(frame.Name);
            return;
        }

        FractionOf(frame).Report(1.0);
        _drawn.TryRemove((frame.Step, frame.CameraIndex), out _);
    }

    private FractionProgress FractionOf(Frame frame) =>
        _drawn.GetOrAdd((frame.Step, frame.CameraIndex), _ => new FractionProgress(display, frame.Name));
}
