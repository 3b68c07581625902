using System.Buffers;
using System.Collections.Concurrent;
using System.Runtime.InteropServices;
using Msisf.Adapters.Albedo;
using Msisf.Adapters.Render;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Terrain;

namespace Msisf.App.Rendering;

/// <summary>
/// Draws frames from the elevation model with the program's own renderer and writes their files. Files of some frames are written while
/// other frames are drawn.
/// </summary>
internal sealed class NativeFrameRenderer : IFrameRenderer
{
    /// <summary>
    /// Number of frames after which the model's memory pages are released. Mapping the pages of the next frames again takes some ms, which
    /// is little compared with the time of 16 frames.
    /// </summary>
    private const int FramesBetweenReleases = 16;

    private readonly NativeSettings _settings;
    private readonly NativeRenderOptions _options;
    private readonly ITerrainGrid _model;
    private readonly OpenedAlbedoMap? _map;
    private readonly NativeLevels _levels;
    private readonly GreyTable _grey;
    private readonly DetectorsOfRun? _detectors;
    private readonly FrameFiles _files;
    private readonly RunTimes _times;
    private readonly ConcurrentBag<MemoryStream> _idleImages = [];
    private int _frames;

    public NativeFrameRenderer(
        NativeSettings settings, ITerrainGrid model, SurfaceInputs maps, NativeLevels levels, FrameFiles files, RunTimes times)
    {
        _settings = settings;
        _options = settings.Render with { Albedo = maps.Albedo?.Map, Hapke = maps.Hapke?.Map };
        _model = model;
        _map = maps.Albedo;
        _levels = levels;
        _grey = new GreyTable(settings.Grey, settings.BitDepth);
        _detectors = settings.Detector is null ? null : new DetectorsOfRun(settings.Detector.Settings);
        _files = files;
        _times = times;
    }

    /// <inheritdoc/>
    public int FramesAhead => 0;

    /// <summary>Does nothing, because no resource is held between frames.</summary>
    public void Dispose()
    {
    }

    /// <inheritdoc/>
    public Task<FrameOutputs> RenderAsync(Frame frame, int threads, CancellationToken cancellation) =>
        Task.Run(() => Render(frame, threads, cancellation), cancellation);

    private FrameOutputs Render(Frame frame, int threads, CancellationToken cancellation)
    {
        CameraDetector? detector = _detectors?.Of(frame.Camera.Model, threads);
        PinholeCamera window = detector is null or { Margin: 0 }
            ? frame.Camera
            : new PinholeCamera(frame.Camera.PositionMoonMe, frame.Camera.MoonFromCamera, detector.WindowModel);
        NativeRenderer renderer = _levels.For(window, _settings.Render.SubsamplesPerAxis);
        NativeRenderOptions options = frame.Motion is { IsRest: false } ? _options with { KeepGroundTruth = true } : _options;
        using NativeFrame drawn = Draw(renderer, window, frame, options, threads, cancellation);
        DetectorImage? detected = detector is null ? null : Expose(detector, renderer, frame, drawn, threads, cancellation);
        MemoryStream image = _idleImages.TryTake(out MemoryStream? idle) ? idle : new MemoryStream();
        image.SetLength(0);
        _times.Measure(Phase.Output, () => Encode(drawn, detected, image));
        IGroundTruth truth = detected is null ? drawn : new DetectedFrame(frame.Camera, drawn, detector!.Margin, detected);
        RenderedFrame rendered = new(
            RendererKind.Native,
            image,
            "the image",
            WriteScene: null,
            renderer.Resolution,
            (renderer.Resolution, renderer.Resolution),
            _settings.Render.KeepGroundTruth ? truth : null,
            detected);
        FrameOutputs outputs = new(_files.Write(frame, rendered, cancellation), TileCount: 0, PatternsMade: 0);
        _idleImages.Add(image);
        if (detected is not null)
        {
            detector!.GiveBack(detected);
        }

        if (Interlocked.Increment(ref _frames) % FramesBetweenReleases == 0)
        {
            _model.ReleasePages(); // an orbit would have the whole model in memory in the end
            _map?.ReleasePages();
        }

        return outputs;
    }

    private NativeFrame Draw(
        NativeRenderer renderer, PinholeCamera camera, Frame frame, NativeRenderOptions options, int threads,
        CancellationToken cancellation) =>
        _times.Measure(Phase.Draw, () => renderer.Render(camera, frame.Light, options, threads, cancellation));

    /// <summary>Sums up the exposure of a frame and reads it out.</summary>
    /// <param name="detector">The detector.</param>
    /// <param name="renderer">Draws the other instants of the exposure.</param>
    /// <param name="frame">The frame.</param>
    /// <param name="middle">It at its own time.</param>
    /// <param name="threads">Number of threads.</param>
    /// <param name="cancellation">Stops the work.</param>
    private DetectorImage Expose(
        CameraDetector detector, NativeRenderer renderer, Frame frame, NativeFrame middle, int threads, CancellationToken cancellation)
    {
        CameraMotion motion = frame.Motion ?? default;
        SubExposures exposures = _times.Measure(
            Phase.Detector, () => detector.SubExposuresOf(middle, motion, threads, cancellation));
        DetectorImage image = detector.Begin(middle);
        NativeRenderOptions options = _options with { KeepGroundTruth = false };
        for (int index = 0; index < exposures.Count; index++)
        {
            using NativeFrame? other = index == exposures.Middle
                ? null
                : Draw(renderer, motion.Moved(middle.Camera, exposures.TimeOf(index)), frame, options, threads, cancellation);
            _times.Measure(
                Phase.Detector, () => detector.Collect(other ?? middle, exposures, index, image, threads, cancellation));
        }

        _times.Measure(Phase.Detector, () => detector.Read(image, frame.Time, middle.Camera, threads, cancellation));
        return image;
    }

    private void Encode(NativeFrame drawn, DetectorImage? detected, MemoryStream image)
    {
        if (detected is null)
        {
            EncodeLevels(drawn, image);
        }
        else
        {
            PngWriter.WriteNumbers(image, detected.Numbers, detected.Width, _settings.Detector!.Settings.ConverterBits);
        }

        image.Position = 0;
    }

    private void EncodeLevels(NativeFrame drawn, MemoryStream image)
    {
        int width = drawn.Camera.Width;
        int pixels = drawn.RadianceFactors.Length;
        byte[] memory = ArrayPool<byte>.Shared.Rent(pixels * _settings.BitDepth / 8);
        if (_settings.BitDepth == 8)
        {
            Span<byte> levels = memory.AsSpan(0, pixels);
            _grey.Convert(drawn.RadianceFactors, levels);
            PngWriter.Write(image, levels, width, _settings.Grey.Transfer);
        }
        else
        {
            Span<ushort> levels = MemoryMarshal.Cast<byte, ushort>(memory.AsSpan(0, 2 * pixels));
            _grey.Convert(drawn.RadianceFactors, levels);
            PngWriter.Write(image, levels, width, _settings.Grey.Transfer);
        }

        ArrayPool<byte>.Shared.Return(memory);
    }
}
