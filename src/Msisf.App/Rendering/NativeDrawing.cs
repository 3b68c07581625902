using System.Runtime;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Products;
using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render;
using Msisf.Core.Terrain;

namespace Msisf.App.Rendering;

/// <summary>Draws frames of one camera and one set of options with the program's own renderer, in memory. Thread-safe.</summary>
internal sealed class NativeDrawing(
    NativeSettings settings, ITerrain model, SurfaceInputs maps, NativeLevels levels, RunTimes times, CameraSky? sky = null)
{
    /// <summary>
    /// Number of frames after which the model's memory pages are released. Mapping the pages of the next frames again takes some ms, which
    /// is little compared with the time of 16 frames.
    /// </summary>
    private const int FramesBetweenReleases = 16;

    /// <summary>
    /// Part of the memory in use that replaced buffers must have before they are returned to the system: this moves all other buffers,
    /// some 50 ms, and an orbit with an image of 1024 x 1024 px does it a few times in a turn.
    /// </summary>
    private const double WorthCollecting = 0.25;

    private readonly NativeRenderOptions _options = settings.Render with
    {
        Albedo = maps.Albedo?.Map,
        AlbedoSites = [.. maps.Sites.Select(site => site.Map)],
        Hapke = maps.Hapke?.Map,
    };

    private readonly DetectorsOfRun? _detectors = settings.Detector is null ? null : new DetectorsOfRun(settings.Detector.Settings);
    private readonly GreyTable _grey = new(settings.Grey, settings.BitDepth);
    private int _frames;
    private long _collectedBytes;

    public NativeSettings Settings { get; } = settings;

    /// <summary>Turns radiance factors of a frame into grey levels.</summary>
    internal GreyTable GreyOf(Frame frame) => frame.ExposureFactor is { } factor
        ? new GreyTable(new GreyScale(factor * Settings.Grey.Exposure, Settings.Grey.Transfer), Settings.BitDepth)
        : _grey;

    /// <param name="threads">Number of threads; the image does not depend on it.</param>
    /// <param name="progress">Is told which part of the light from the ground is done; null for nobody.</param>
    /// <returns>The image. Dispose it so that later frames can use its memory.</returns>
    public NativeImage Draw(Frame frame, int threads, CancellationToken cancellation, IProgress<double>? progress = null)
    {
        ScannedShot? shot = ShotOf(frame);
        if (shot is not null && frame.Scan is not null)
        {
            PixelRows all = new(0, frame.Camera.Height);
            return DrawExposures(frame, shot, RendererOf(frame), all, OptionsOf(frame), threads, cancellation);
        }

        CameraDetector? detector = _detectors?.Of(frame.Camera, frame.ExposureFactor, threads);
        ICamera window = detector?.WindowOf(frame.Camera) ?? frame.Camera;
        NativeRenderer renderer = levels.For(window, Settings.Render.DetailSubsamplesPerAxis);
        NativeRenderOptions options = OptionsOf(frame) with
        {
            KeepGroundTruth = _options.KeepGroundTruth || frame.Motion is { IsRest: false },
            Progress = progress,
        };
        NativeFrame drawn = Draw(renderer, window, frame, options, threads, cancellation);
        try
        {
            FrameLights? lights = SkyOf(frame, window, detector);
            DetectorImage? detected = detector is null ? null
                : shot is null ? Expose(detector, renderer, frame, drawn, lights, threads, cancellation)
                : ExposeRows(detector, renderer, frame, shot with { NoiseCamera = drawn.Camera }, lights, threads, cancellation);
            return new NativeImage(this, renderer, frame, drawn, detector, detected, Found(lights, frame, detector, threads, cancellation));
        }
        catch
        {
            drawn.Dispose();
            throw;
        }
    }

    /// <summary>The lights of a frame's sky; null where none is drawn.</summary>
    /// <param name="drawn">The camera with which its ground is drawn.</param>
    private FrameLights? SkyOf(Frame frame, ICamera drawn, CameraDetector? detector) => sky is null ? null : sky.Of(
        frame, levels.TracerFor(drawn, Settings.Render.DetailSubsamplesPerAxis), detector,
        Settings.Detector is { Settings: var exposed }
            ? exposed.Exposed(frame.ExposureFactor) is var own && own.Shutter is { } shutter
                ? shutter.Span(own.ExposureTime, frame.Camera.Height)
                : own.ExposureTime
            : 0.0);

    private SkyOfFrame? Found(
        FrameLights? lights, Frame frame, CameraDetector? detector, int threads, CancellationToken cancellation) => lights is null ? null
        : times.Measure(Phase.Sky, () => sky!.Find(
            lights, frame.Camera, row => frame.Light.At(frame.Camera, row).PositionBodyFixed, detector is not null, threads, cancellation));

    /// <summary>Counts a frame whose image is done with, and releases the model's memory pages now and then.</summary>
    internal void Finished()
    {
        if (Interlocked.Increment(ref _frames) % FramesBetweenReleases == 0)
        {
            model.ReleasePages(); // an orbit would have the whole model in memory in the end
            maps.ReleasePages();
            ReturnReplaced();
        }
    }

    /// <summary>
    /// Returns the memory of buffers to the system that few frames needed: those over a pole or at the terminator.
    /// </summary>
    private void ReturnReplaced()
    {
        long replaced = levels.ReplacedBytes;
        if (replaced - Interlocked.Read(ref _collectedBytes) > WorthCollecting * GC.GetTotalMemory(forceFullCollection: false))
        {
            Interlocked.Exchange(ref _collectedBytes, replaced);
            GCSettings.LargeObjectHeapCompactionMode = GCLargeObjectHeapCompactionMode.CompactOnce;
            GC.Collect(GC.MaxGeneration, GCCollectionMode.Aggressive, blocking: true, compacting: true);
        }
    }

    /// <summary>The renderer's options, with the maps and the lights of a frame.</summary>
    internal NativeRenderOptions OptionsOf(Frame frame) => frame.Earth is { } earth ? _options with { Second = earth } : _options;

    private NativeFrame Draw(
        NativeRenderer renderer, ICamera camera, Frame frame, NativeRenderOptions options, int threads,
        CancellationToken cancellation) =>
        times.Measure(Phase.Draw, () => renderer.Render(camera, frame.Light, options, threads, cancellation));

    /// <summary>The renderer of a frame's level of detail.</summary>
    public NativeRenderer RendererOf(Frame frame) => levels.For(frame.Camera, Settings.Render.DetailSubsamplesPerAxis);

    /// <summary>Draws some rows of an image that is scanned: those of whole exposures.</summary>
    /// <param name="keepsTruth">Whether their ground truth is asked for.</param>
    /// <param name="threads">Number of threads; the rows do not depend on it.</param>
    public NativeImage DrawRows(
        Frame frame, NativeRenderer renderer, PixelRows rows, bool keepsTruth, int threads, CancellationToken cancellation)
    {
        NativeRenderOptions options = OptionsOf(frame) with { KeepGroundTruth = keepsTruth };
        if (ShotOf(frame) is { } shot)
        {
            return DrawExposures(frame, shot, renderer, rows, options, threads, cancellation);
        }

        NativeFrame drawn = times.Measure(
            Phase.Draw, () => renderer.RenderRows(frame.Camera, frame.Light, rows, options, threads, cancellation));
        return new NativeImage(this, renderer, frame with { Camera = drawn.Camera }, drawn, null, null);
    }

    /// <summary>Draws and exposes rows of an image that is scanned.</summary>
    private NativeImage DrawExposures(
        Frame frame, ScannedShot shot, NativeRenderer renderer, PixelRows rows, NativeRenderOptions options, int threads,
        CancellationToken cancellation)
    {
        CameraDetector detector = _detectors!.Of(ScanReadout.CameraOf(shot), frame.ExposureFactor, threads);
        FrameLights? lights = SkyOf(frame, frame.Camera, detector);
        ScanReadout readout = new(detector, renderer, options) { Points = lights };
        (NativeFrame drawn, DetectorImage image) = times.Measure(
            Phase.Detector, () => readout.Expose(shot, rows, threads, cancellation));
        return new NativeImage(
            this, renderer, frame with { Camera = drawn.Camera }, drawn, null, image,
            Found(lights, frame, detector, threads, cancellation));
    }

    /// <summary>Exposes the rows of a frame one by one, each about its own time, and reads them out together.</summary>
    /// <param name="renderer">Draws the rows.</param>
    /// <param name="lights">The lights of the sky; null for none.</param>
    private DetectorImage ExposeRows(
        CameraDetector detector, NativeRenderer renderer, Frame frame, ScannedShot shot, FrameLights? lights, int threads,
        CancellationToken cancellation)
    {
        ScanReadout readout = new(detector, renderer, OptionsOf(frame) with { KeepGroundTruth = false }) { Points = lights };
        return times.Measure(
            Phase.Detector, () => readout.Expose(shot, new PixelRows(0, shot.Scan.Count), threads, cancellation).Image);
    }

    private ScannedShot? ShotOf(Frame frame) =>
        Settings.Detector is { Settings: var detector } ? frame.ShotOf(detector.Exposed(frame.ExposureFactor)) : null;

    /// <summary>Sums up the exposure of a frame and reads it out.</summary>
    /// <param name="renderer">Draws the other instants of the exposure.</param>
    /// <param name="middle">It at its own time.</param>
    /// <param name="lights">The lights of the sky; null for none.</param>
    private DetectorImage Expose(
        CameraDetector detector, NativeRenderer renderer, Frame frame, NativeFrame middle, FrameLights? lights, int threads,
        CancellationToken cancellation)
    {
        CameraMotion motion = frame.Motion ?? default;
        SubExposures exposures = times.Measure(
            Phase.Detector, () => detector.SubExposuresOf(middle, motion, threads, cancellation));
        DetectorImage image = detector.Begin(middle);
        NativeRenderOptions options = OptionsOf(frame) with { KeepGroundTruth = false };
        for (int index = 0; index < exposures.Count; index++)
        {
            using NativeFrame? other = index == exposures.Middle
                ? null
                : Draw(renderer, InstantOf(exposures.TimeOf(index)), frame, options, threads, cancellation);
            times.Measure(
                Phase.Detector, () => detector.Collect(other ?? middle, exposures.Weight, image, threads, cancellation));
        }

        if (lights is not null)
        {
            DetectorSettings exposed = Settings.Detector!.Settings.Exposed(frame.ExposureFactor);
            double span = exposed.Shutter is null ? 0.0 : exposed.ExposureTime;
            PointExposure whole = new(new PixelRows(0, image.Height), CameraOf, 0.0, span)
            {
                AngularSpeed = motion.AngularVelocityCamera.Length,
            };
            times.Measure(Phase.Sky, () => lights.Collect(whole, detector, image, cancellation));
        }

        FrameCamera CameraOf(double seconds) => frame is { Path: { } path, Model: { } camera }
            ? camera.At(path.At(seconds))
            : (FrameCamera)frame.Camera.Moved(motion, seconds);

        ICamera InstantOf(double seconds) => frame is { Path: { } path, Model: { } camera }
            ? detector.WindowOf(camera.At(path.At(seconds)))
            : middle.Camera.Moved(motion, seconds);

        times.Measure(Phase.Detector, () => detector.Read(image, frame.Time, middle.Camera, frame.Noise, threads, cancellation));
        return image;
    }
}

/// <summary>
/// The detector of a run, made for its first frame, which all frames share that are exposed as long as the settings say. Thread-safe.
/// </summary>
internal sealed class DetectorsOfRun(DetectorSettings settings)
{
    private readonly Lock _gate = new();
    private CameraDetector? _detector;

    /// <param name="camera">A frame's camera; its states do not matter, the rest is the same for all frames.</param>
    /// <param name="factor">By how much longer the frame is exposed; null for as long.</param>
    public CameraDetector Of(ICamera camera, double? factor, int threads)
    {
        if (factor is not null)
        {
            return new CameraDetector(settings.Exposed(factor), camera, threads);
        }

        lock (_gate)
        {
            return _detector ??= new CameraDetector(settings, camera, threads);
        }
    }
}
