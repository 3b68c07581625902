using System.Collections.Concurrent;
using System.Runtime.CompilerServices;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Products;
using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Render;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.App.Rendering;

/// <summary>
/// Draws frames from the elevation model with the program's own renderer and writes their files. Files of some frames are written while
/// other frames are drawn.
/// </summary>
/// <param name="exposure">Watches the exposure of a detector; null without one.</param>
/// <param name="progress">Is told which part of a frame is drawn.</param>
internal sealed class NativeFrameRenderer(
    NativeDrawing drawing, FrameFiles files, ExposureNote? exposure, FrameProgress progress, RunTimes times) : IFrameRenderer
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

        using NativeImage drawn = drawing.Draw(frame, threads, cancellation, progress.Of(frame));
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

/// <summary>
/// The native renderers of a run: one for each terrain that a frame needs, as long as that is kept. Thread-safe.
/// </summary>
/// <param name="terrain">Chooses the terrain of a frame.</param>
/// <param name="memory">Buffers of the renderers; null for those that keep the buffers of all frames.</param>
internal sealed class NativeLevels(IFrameTerrain terrain, RendererMemory? memory = null)
{
    private readonly ConditionalWeakTable<ITerrain, Lazy<NativeRenderer>> _renderers = [];
    private readonly ConditionalWeakTable<ITerrain, Lazy<TerrainTracer>> _tracers = [];
    private readonly RendererMemory _memory = memory ?? new RendererMemory();

    /// <summary>Bytes of the buffers that the renderers have replaced so far (<see cref="RendererMemory.ReplacedBytes"/>).</summary>
    public long ReplacedBytes => _memory.ReplacedBytes;

    public NativeRenderer For(ICamera camera, int subsamplesPerAxis) => _renderers.GetValue(
        terrain.For(camera, subsamplesPerAxis), MakeRenderer).Value;

    /// <summary>The first invented part of a frame (<see cref="ITerrain.FirstInventedPart"/>).</summary>
    public int? FirstInventedPart(ICamera camera, int subsamplesPerAxis) => terrain.For(camera, subsamplesPerAxis).FirstInventedPart;

    /// <summary>Traces single rays through the surface that a frame shows.</summary>
    public ITerrainTracer TracerFor(ICamera camera, int subsamplesPerAxis) => _tracers.GetValue(
        terrain.For(camera, subsamplesPerAxis), static drawn => new Lazy<TerrainTracer>(() => new TerrainTracer(drawn))).Value;

    private Lazy<NativeRenderer> MakeRenderer(ITerrain drawn) => new(() => new NativeRenderer(drawn, _memory));
}
