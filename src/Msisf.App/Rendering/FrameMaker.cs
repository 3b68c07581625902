using System.Diagnostics;
using Msisf.Adapters.Manifest;
using Msisf.App.Preparation;
using Msisf.App.Series;

namespace Msisf.App.Rendering;

/// <summary>Makes a frame unless it already exists and is complete, or another process is making it. Thread-safe.</summary>
/// <param name="render">Draws a frame with some threads and writes its files.</param>
/// <param name="ledger">Records of the run's frames.</param>
internal sealed class FrameMaker(Func<Frame, int, CancellationToken, Task<FrameOutputs>> render, FrameLedger ledger, FrameTimes times)
{
    private static readonly TimeSpan Poll = TimeSpan.FromMilliseconds(50);

    /// <summary>
    /// Maximum time to wait for another process that has claimed a frame. A claim ends at once when its process dies; if the process hangs,
    /// the frame is made a second time, with the same bytes.
    /// </summary>
    private static readonly TimeSpan LongestWait = TimeSpan.FromMinutes(10);

    /// <summary>Makes a frame, unless another process is making it.</summary>
    /// <param name="cancellation">Cancels the work; no file is left.</param>
    /// <returns>The frame's files; null if another process is making it.</returns>
    /// <exception cref="MsisfException">The frame could not be made; the cause is in the manifest.</exception>
    public async Task<FrameOutputs?> TryMakeAsync(Frame frame, int threads, CancellationToken cancellation)
    {
        using IDisposable? claim = ledger.TryClaim(frame);
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
        if (ledger.Check(frame).State == FrameState.Complete)
        {
            return new FrameOutputs(ledger.PathsOf(frame), TileCount: 0, PatternsMade: 0, WasThere: true);
        }

        try
        {
            long start = Stopwatch.GetTimestamp();
            FrameOutputs outputs = await render(frame, threads, cancellation).ConfigureAwait(false);
            times.Add(frame, Stopwatch.GetElapsedTime(start));
            return outputs;
        }
        catch (Exception exception) when (exception is MsisfException or OutOfMemoryException)
        {
            MsisfException cause = exception as MsisfException
                ?? new ExternalPartException(
                    "the memory does not suffice. Use a smaller --width and --height, or fewer --jobs.", exception);
            ledger.Failed(frame, cause.Message);
            if (cause == exception)
            {
                throw;
            }

            throw cause;
        }
    }
}
