using Msisf.Core.Camera;
using Msisf.Core.Parallel;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;

namespace Msisf.Core.Detector;

/// <summary>
/// Exposes a scanned image: each exposure is drawn and collected by itself, with all instants of its time and all stages of its TDI. Lines
/// and framelets are read out each after its exposure, the rows of a rolling shutter all at the end.
/// </summary>
/// <param name="detector">The detector: of one line or framelet, or of the whole image.</param>
public sealed class ScanReadout(CameraDetector detector, NativeRenderer renderer, NativeRenderOptions options)
{
    private readonly CameraDetector _detector = detector;
    private readonly NativeRenderer _renderer = renderer;
    private readonly NativeRenderOptions _options = options;

    /// <summary>Points of light beside the ground; null for none.</summary>
    public IPointLights? Points { get; init; }

    /// <summary>The camera of which a scan has the detector.</summary>
    public static FrameCamera CameraOf(ScannedShot shot) => (shot.Scan.Kind == ScanKind.RollingShutter
        ? shot.Model
        : shot.Scan.ExposureOf(shot.Model, 0, 0.0)).At(shot.Path.States[0]);

    /// <summary>Exposes and reads out an image, or some of its rows.</summary>
    /// <param name="rows">The rows: those of whole exposures; of a rolling shutter all.</param>
    /// <param name="threads">Number of threads; the image does not depend on it.</param>
    /// <returns>What is drawn in the middle of each exposure, and the detector's numbers.</returns>
    public (NativeFrame Drawn, DetectorImage Image) Expose(
        ScannedShot shot, PixelRows rows, int threads, CancellationToken cancellation)
    {
        ICamera camera = shot.Camera.Window(0, rows.First, shot.Camera.Width, rows.End - rows.First);
        DrawnBands drawn = new(camera, shot.Light.At(shot.Camera, rows.First + 1));
        DetectorImage whole = new(camera.Width, camera.Height) { Noise = shot.Noise };
        int[] exposures =
        [
            .. Enumerable.Range(0, shot.Scan.Count).Where(exposure =>
                shot.Scan.ImageRowOf(shot.Model, exposure, 0) is var row && row >= rows.First && row < rows.End),
        ];
        bool isRolling = shot.Scan.Kind == ScanKind.RollingShutter;
        WorkerTeam.Run(
            threads,
            exposures.Length,
            (_, index) =>
            {
                Exposure one = new(this, shot, exposures[index], drawn, isRolling ? whole : null, cancellation);
                one.Run(whole, rows.First);
            },
            cancellation);
        if (isRolling)
        {
            _detector.Read(whole, shot.Time, shot.NoiseCamera ?? shot.Camera, shot.Noise, threads, cancellation);
        }

        return (new NativeFrame(drawn, static () => { }), whole);
    }

    /// <summary>One exposure of a scan.</summary>
    /// <param name="number">From 0.</param>
    /// <param name="drawn">Gets what the exposure's pixels show in the middle of its time.</param>
    /// <param name="shared">The detector's image that all exposures share; null for one of its own.</param>
    private sealed class Exposure(
        ScanReadout readout, ScannedShot shot, int number, DrawnBands drawn, DetectorImage? shared, CancellationToken cancellation)
    {
        private readonly CameraDetector _detector = readout._detector;
        private readonly double _middle = shot.Scan.SecondsOf(number);

        public void Run(DetectorImage whole, int firstRow)
        {
            FrameCamera middleCamera = At(0.0, 0.0);
            bool isMoving = shot.HasShutter;
            NativeRenderOptions ofMiddle = isMoving ? readout._options with { KeepGroundTruth = true } : readout._options;
            using NativeFrame middle = Draw(middleCamera, ofMiddle);
            CameraMotion motion = isMoving
                ? shot.Path.FastestMotion(_middle - shot.HalfExposure, _middle + shot.HalfExposure)
                : default;
            SubExposures instants = _detector.SubExposuresOf(middle, motion, 1, cancellation);
            PixelRows rows = shot.Scan.DetectorRowsOf(shot.Model, number);
            DetectorImage image = shared ?? _detector.Begin(middle);
            Collect(middle, instants, rows, image);
            CollectPoints(motion, rows, image);
            if (shared is null)
            {
                _detector.Read(image, shot.Time.After(_middle), middleCamera, shot.NoiseOf(number), 1, cancellation);
            }

            DetectedFrame seen = new(middleCamera, middle, _detector.Margin, image);
            for (int row = 0; row < middleCamera.Height; row++)
            {
                int target = shot.Scan.ImageRowOf(shot.Model, number, row) - firstRow;
                drawn.Take(seen, row, target, readout._options.KeepGroundTruth);
                if (shared is null)
                {
                    whole.Take(image, row, target);
                }
            }

            if (shared is null)
            {
                _detector.GiveBack(image);
            }
        }

        private void Collect(NativeFrame middle, SubExposures instants, PixelRows rows, DetectorImage image)
        {
            NativeRenderOptions ofOthers = readout._options with { KeepGroundTruth = false };
            for (int stage = 0; stage < shot.Scan.Stages; stage++)
            {
                (double rowsBelow, double seconds) = shot.Scan.Stage(stage);
                for (int index = 0; index < instants.Count; index++)
                {
                    bool isMiddle = index == instants.Middle && rowsBelow == 0.0;
                    using NativeFrame? other = isMiddle ? null : Draw(At(seconds + instants.TimeOf(index), rowsBelow), ofOthers);
                    _detector.Collect(other ?? middle, rows, instants.Weight, image, 1, cancellation);
                }
            }
        }

        private void CollectPoints(CameraMotion motion, PixelRows rows, DetectorImage image)
        {
            for (int stage = 0; readout.Points is { } points && stage < shot.Scan.Stages; stage++)
            {
                (double rowsBelow, double seconds) = shot.Scan.Stage(stage);
                PointExposure exposure = new(
                    rows, time => At(time - _middle, rowsBelow), _middle + seconds, 2.0 * shot.HalfExposure)
                {
                    AngularSpeed = motion.AngularVelocityCamera.Length,
                };
                points.Collect(exposure, _detector, image, cancellation);
            }
        }

        /// <summary>The camera of the exposure some seconds after its middle, with the Sun of its middle.</summary>
        private FrameCamera At(double seconds, double rowsBelow)
        {
            CameraState middle = shot.Camera.BandAt(shot.Scan.ImageRowOf(shot.Model, number, 0) + 1).Camera.State;
            CameraState state = seconds == 0.0
                ? middle
                : shot.Path.At(_middle + seconds) with { SunPositionBodyFixed = middle.SunPositionBodyFixed };
            return shot.Scan.ExposureOf(shot.Model, number, rowsBelow).At(state);
        }

        private NativeFrame Draw(ICamera camera, NativeRenderOptions options)
        {
            ICamera window = _detector.WindowOf(camera);
            return readout._renderer.Render(window, shot.Light.Of(window.State), options, threads: 1, cancellation);
        }
    }
}
