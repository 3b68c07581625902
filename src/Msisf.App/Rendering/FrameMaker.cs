using System.Diagnostics;
using Msisf.Adapters.Manifest;
using Msisf.App.Preparation;
using Msisf.App.Series;
using Msisf.Core.Errors;

namespace Msisf.App.Rendering;

/// <summary>Makes a frame if it is not there and complete, and no other process is making it. Safe for several threads.</summary>
internal sealed class FrameMaker
{
    private static readonly TimeSpan Poll = TimeSpan.FromMilliseconds(50);

    /// <summary>
    /// A process that dies gives its claims back at once; one that is stopped or hangs is not waited for: the frame is made twice then, the
    /// same bytes.
    /// </summary>
    private static readonly TimeSpan LongestWait = TimeSpan.FromMinutes(10);

    private readonly Func<Frame, int, CancellationToken, Task<FrameOutputs>> _render;
    private readonly FrameLedger _ledger;
    private readonly FrameTimes _times;

    /// <param name="render">Draws a frame with some threads and writes its files.</param>
    /// <param name="ledger">Of the run.</param>
    /// <param name="times">Gets the time of each frame that is made.</param>
    public FrameMaker(Func<Frame, int, CancellationToken, Task<FrameOutputs>> render, FrameLedger ledger, FrameTimes times)
    {
        _render = render;
        _ledger = ledger;
        _times = times;
    }

    /// <summary>Makes a frame, unless another process is making it.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="threads">To draw it with.</param>
    /// <param name="cancellation">Leaves no file.</param>
    /// <returns>Its files; null if another process is making it.</returns>
    /// <exception cref="MsisfException">It could not be made; the manifest knows why.</exception>
    public async Task<FrameOutputs?> TryMakeAsync(Frame frame, int threads, CancellationToken cancellation)
    {
        using IDisposable? claim = _ledger.TryClaim(frame);
        return claim is null ? null : await MakeIfNeededAsync(frame, threads, cancellation).ConfigureAwait(false);
    }

    /// <summary>Makes a frame, or waits until another process has made it.</summary>
    /// <inheritdoc cref="TryMakeAsync"/>
    public async Task<FrameOutputs> MakeAsync(Frame frame, int threads, CancellationToken cancellation)
    {
        for (long start = Stopwatch.GetTimestamp(); Stopwatch.GetElapsedTime(start) < LongestWait;)
        {
            if (await TryMakeAsync(frame, threads, cancellation).ConfigureAwait(false) is FrameOutputs outputs)
            {
                return outputs;
            }

            await Task.Delay(Poll, cancellation).ConfigureAwait(false);
        }

        return await MakeIfNeededAsync(frame, threads, cancellation).ConfigureAwait(false);
    }

    private async Task<FrameOutputs> MakeIfNeededAsync(Frame frame, int threads, CancellationToken cancellation)
    {
        if (_ledger.Check(frame).State == FrameState.Complete)
        {
            return new FrameOutputs(_ledger.PathsOf(frame), TileCount: 0, PatternsMade: 0, WasThere: true);
        }

        try
        {
            long start = Stopwatch.GetTimestamp();
            FrameOutputs outputs = await _render(frame, threads, cancellation).ConfigureAwait(false);
            _times.Add(frame, Stopwatch.GetElapsedTime(start));
            return outputs;
        }
        catch (Exception exception) when (exception is MsisfException or OutOfMemoryException)
        {
            MsisfException cause = exception as MsisfException
                ?? new ExternalPartException(
                    "the memory does not suffice. Use a smaller --width and --height, or fewer --jobs.", exception);
            _ledger.Failed(frame, cause.Message);
            if (cause == exception)
            {
                throw;
            }

            throw cause;
        }
    }
}
