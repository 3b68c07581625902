using Msisf.Cli.Progress;
using Msisf.Core.Errors;

namespace Msisf.Cli.Run;

/// <summary>
/// Makes many frames, several at once, so that what draws them uses the cores once. A frame that fails is recorded, and the rest goes on.
/// </summary>
internal sealed class FrameLoop
{
    private readonly Func<Frame, int, CancellationToken, Task<FrameOutputs>> _render;
    private readonly int _ahead;
    private readonly IRunProgress _progress;
    private readonly TextWriter _results;
    private readonly Log _log;

    /// <param name="render">Makes one frame with some threads; keeps by itself to the number of frames that are drawn at once.</param>
    /// <param name="ahead">So many frames more are begun (<see cref="IFrameRenderer.FramesAhead"/>).</param>
    /// <param name="progress">Is told of each frame.</param>
    /// <param name="results">Gets the paths.</param>
    /// <param name="log">Gets the errors of single frames.</param>
    public FrameLoop(
        Func<Frame, int, CancellationToken, Task<FrameOutputs>> render, int ahead, IRunProgress progress, TextWriter results, Log log)
    {
        _ahead = ahead;
        _render = render;
        _progress = progress;
        _results = results;
        _log = log;
    }

    /// <summary>How many frames run at once: as many as there are cores, unless the user says otherwise.</summary>
    public static int AtOnce(int frames, int? jobs, int cores) => Math.Clamp(jobs ?? cores, 1, Math.Max(1, frames));

    /// <summary>Makes all frames; the paths of a frame's files are printed as soon as those of all frames before it are.</summary>
    /// <exception cref="MsisfException">The only frame of the run failed: its own error. Several frames: an <see cref="ExternalPartException"/> that counts them.</exception>
    public async Task<IReadOnlyList<FrameOutputs>> RunAsync(IReadOnlyList<Frame> frames, int? jobs, int cores, CancellationToken cancellation)
    {
        int atOnce = AtOnce(frames.Count, jobs, cores);
        int threads = Math.Max(1, cores / atOnce);
        FrameOutputs[] outputs = new FrameOutputs[frames.Count];
        List<int> failed = [];
        OrderedPrinter printer = new(_results, frames.Count);
        await Parallel.ForAsync(0, frames.Count, Options(Math.Min(atOnce + _ahead, Math.Max(1, frames.Count)), cancellation), async (index, stop) =>
        {
            Frame frame = frames[index];
            IReadOnlyList<string> paths = [];
            try
            {
                outputs[index] = await _render(frame, threads, stop).ConfigureAwait(false);
                paths = outputs[index].Paths;
            }
            catch (MsisfException exception) when (frames.Count > 1)
            {
                _log.Error($"step {frame.Step} ({frame.Name}): {exception.Message}");
                lock (failed)
                {
                    failed.Add(frame.Step);
                }
            }

            printer.Done(index, paths);
            _progress.Advance(frame.Name);
        }).ConfigureAwait(false);
        return failed.Count == 0
            ? outputs
            : throw new ExternalPartException($"{failed.Count} of {frames.Count} frames failed: steps {string.Join(", ", failed.Order())}. The others are complete.");
    }

    private static ParallelOptions Options(int atOnce, CancellationToken cancellation) =>
        new() { MaxDegreeOfParallelism = atOnce, CancellationToken = cancellation };
}
