using System.Collections.Concurrent;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.Core.Scene;

namespace Msisf.App.Rendering;

/// <summary>
/// Makes many frames, several at once, so that the cores are neither idle nor shared by too many threads. A failed frame is recorded, and
/// the other frames are still made. A frame that another process is making is handled last.
/// </summary>
internal sealed class FrameLoop
{
    private readonly FrameMaker _maker;
    private readonly int _ahead;
    private readonly bool _failFast;
    private readonly IRunProgress _progress;
    private readonly TextWriter _results;
    private readonly ILog _log;

    /// <param name="maker">Makes one frame; the renderer itself limits how many frames are drawn at once.</param>
    /// <param name="ahead">
    /// Number of frames to begin in addition to those that are drawn at once (<see cref="IFrameRenderer.FramesAhead"/>).
    /// </param>
    /// <param name="failFast">Whether the first failed frame ends the run.</param>
    /// <param name="progress">Progress display; receives one step per frame.</param>
    /// <param name="results">Receives the paths of the files.</param>
    /// <param name="log">Receives the errors of single frames.</param>
    public FrameLoop(FrameMaker maker, int ahead, bool failFast, IRunProgress progress, TextWriter results, ILog log)
    {
        _maker = maker;
        _ahead = ahead;
        _failFast = failFast;
        _progress = progress;
        _results = results;
        _log = log;
    }

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
        OrderedPrinter printer = new(_results, frames.Count);
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
                if (_failFast)
                {
                    throw new ExternalPartException(
                        $"{message} Stopped there, as --fail-fast asks; finished frames are complete.", exception);
                }

                _log.Error(message);
            }

            printer.Done(index, outputs[index]?.Paths ?? []);
            _progress.Advance(frame.Name);
        }

        ParallelOptions options = new()
        {
            MaxDegreeOfParallelism = Math.Min(atOnce + _ahead, Math.Max(1, frames.Count)),
            CancellationToken = cancellation,
        };
        int[] missing = [.. Enumerable.Range(0, frames.Count).Where(index => known[index] is null)];
        foreach (int index in Enumerable.Range(0, frames.Count).Except(missing))
        {
            printer.Done(index, known[index]!.Paths);
        }

        await Parallel.ForEachAsync(missing, options, (index, stop) => Make(index, _maker.TryMakeAsync, stop)).ConfigureAwait(false);
        await Parallel.ForEachAsync(
            elsewhere.Order().ToArray(),
            options,
            (index, stop) => Make(
                index,
                async (frame, share, end) => await _maker.MakeAsync(frame, share, end).ConfigureAwait(false),
                stop)).ConfigureAwait(false);
        return failed.IsEmpty
            ? [.. outputs.OfType<FrameOutputs>()]
            : throw new ExternalPartException(
                $"{failed.Count} of {frames.Count} frames failed: steps {StepRanges.Of(failed.Distinct())}. The others are complete.");
    }
}
