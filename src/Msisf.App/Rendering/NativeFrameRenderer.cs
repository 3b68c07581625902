using System.Collections.Concurrent;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;

namespace Msisf.App.Rendering;

/// <summary>
/// Draws frames from the elevation model with the program's own renderer and writes their files. Files of some frames are written while
/// other frames are drawn.
/// </summary>
/// <param name="exposure">Watches the exposure of a detector; null without one.</param>
/// <param name="times">Receives the time for the image.</param>
internal sealed class NativeFrameRenderer(NativeDrawing drawing, FrameFiles files, ExposureNote? exposure, RunTimes times) : IFrameRenderer
{
    private readonly ConcurrentBag<MemoryStream> _idleImages = [];

    public int FramesAhead => 0;

    /// <summary>Does nothing, because no resource is held between frames.</summary>
    public void Dispose()
    {
    }

    public Task<FrameOutputs> RenderAsync(Frame frame, int threads, CancellationToken cancellation) =>
        Task.Run(() => Render(frame, threads, cancellation), cancellation);

    private FrameOutputs Render(Frame frame, int threads, CancellationToken cancellation)
    {
        if (StripRules.IsStriped(frame.Scan, frame.Camera.Width, frame.Camera.Height))
        {
            StripedScan scan = new(drawing, files, times);
            return new FrameOutputs(scan.Write(frame, threads, cancellation), TileCount: 0, PatternsMade: 0);
        }

        using NativeImage drawn = drawing.Draw(frame, threads, cancellation);
        if (drawn.Detected is { } detected)
        {
            exposure?.Add(frame.Step, detected, drawn.RadianceFactors);
        }

        MemoryStream image = _idleImages.TryTake(out MemoryStream? idle) ? idle : new MemoryStream();
        image.SetLength(0);
        times.Measure(Phase.Output, () => drawn.WritePng(image));
        image.Position = 0;
        FrameOutputs outputs = new(files.Write(frame, drawn.ToRendered(image, threads), cancellation), TileCount: 0, PatternsMade: 0);
        _idleImages.Add(image);
        return outputs;
    }
}
