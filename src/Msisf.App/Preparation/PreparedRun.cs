using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.App.Preparation;

/// <summary>
/// A run whose input and cameras were read and checked; a run that could not be finished is rejected before the first image.
/// </summary>
/// <param name="Cameras">The states and frames of each camera; one without a rig.</param>
/// <param name="Model">The elevation model; disposed with this object.</param>
internal sealed record PreparedRun(IReadOnlyList<RunFrames> Cameras, ElevationModel Model) : IDisposable
{
    /// <summary>Which kernels give the body's frame, for cameras on the trajectory of a mission; null for others.</summary>
    public string? Orientation { get; private init; }

    /// <summary>The frames to make, those of a step one after the other.</summary>
    public IReadOnlyList<Frame> Frames { get; } =
        [.. from index in Enumerable.Range(0, Cameras[0].Frames.Count) from camera in Cameras select camera.Frames[index]];

    /// <summary>Reads the states, sets up the frames, opens the elevation model, and checks all of it.</summary>
    /// <param name="trajectory">The positions of the camera, or of the body that carries several.</param>
    /// <param name="cameras">The run's other settings: those of each camera.</param>
    /// <param name="ephemeris">Opened if the states or the Sun need it.</param>
    public static PreparedRun Of(
        TrajectorySettings trajectory, IReadOnlyList<RenderSettings> cameras, EphemerisSource ephemeris, ProgramHost host,
        CancellationToken cancellation)
    {
        ModelOnDemand model = new(cameras[0], host, cancellation);
        try
        {
            IReadOnlyList<RunFrames> run = RunFrames.Read(trajectory, cameras, ephemeris, model, host, cancellation);
            foreach (RunFrames camera in run)
            {
                GroundCheck.Refuse(
                    camera.Frames, model.Opened, camera.Settings.ShutterSpan, cancellation, camera.Settings.Body, trajectory);
                camera.WarnOfCamera(host, model.Opened.Grid.ReferenceRadius);
            }

            return new PreparedRun(run, model.Opened)
            {
                Orientation = cameras[0].IsMission ? ephemeris.Orientation : null,
            };
        }
        catch
        {
            model.Dispose();
            throw;
        }
    }

    public void Dispose() => Model.Dispose();
}

/// <summary>Refuses cameras that lie below the terrain.</summary>
internal static class GroundCheck
{
    /// <summary>Maximum number of steps that a message names.</summary>
    private const int NamedSteps = 5;

    /// <summary>Checks the cameras of all frames.</summary>
    /// <param name="model">The terrain; null to take the reference sphere for it.</param>
    /// <param name="span">s: how long the shutter is open about a frame's time; matters for cameras that move.</param>
    /// <param name="body">The body; null for the Moon.</param>
    /// <param name="trajectory">How the positions were given, for the advice.</param>
    /// <exception cref="BadInputException">A camera lies below the terrain; the message names the steps.</exception>
    public static void Refuse(
        IReadOnlyList<Frame> frames, ElevationModel? model, double span, CancellationToken cancellation, CelestialBody? body = null,
        TrajectorySettings? trajectory = null)
    {
        double reference = model?.Grid.ReferenceRadius ?? MoonConstants.ReferenceRadius;
        List<string> buried = [];
        int count = 0;
        string unit = string.Empty;
        foreach (Frame frame in frames)
        {
            cancellation.ThrowIfCancellationRequested();
            Vector3D position = frame.Camera.PositionBodyFixed;
            double depth = frame.Camera.Bands.Max(band => Depth(band.Camera.PositionBodyFixed));
            if (frame.Motion is { IsRest: false } motion)
            {
                // At the ends of the way, and where it is nearest to the Moon's centre.
                Vector3D way = 0.5 * span * motion.VelocityBodyFixed;
                double squared = Vector3D.Dot(way, way);
                double nearest = squared > 0.0 ? Math.Clamp(-Vector3D.Dot(position, way) / squared, -1.0, 1.0) : 0.0;
                depth = new[] { depth, Depth(position - way), Depth(position + way), Depth(position + (nearest * way)) }.Max();
            }

            if (depth > 0.0 && ++count <= NamedSteps)
            {
                unit = buried.Count == 0 ? PlausibleMistakes.Inside(position, body ?? CelestialBody.Moon, trajectory) : unit;
                buried.Add(Invariant($"step {frame.Step} (MJD {frame.Time.Mjd:R}) by {depth:F1} m"));
            }
        }

        if (count > 0)
        {
            string rest = count > NamedSteps ? $" and {count - NamedSteps} more" : string.Empty;
            throw new BadInputException(
                $"the camera is inside {(body ?? CelestialBody.Moon).NameInText}: {string.Join(", ", buried)}{rest}. "
                    + $"Choose positions above the terrain.{unit}");
        }

        // A way may lead through the centre, above which there is no place of the model.
        double Depth(Vector3D position) => position.Length < 0.5 * reference
            ? reference - position.Length
            : model?.DepthBelowGround(position) ?? reference - position.Length;
    }
}

/// <summary>Compares how the ground moves over the detector of a camera that scans with how it should.</summary>
internal static class ScanCheck
{
    /// <summary>px: how far the ground may move aside of the charge's step, which smears a line of TDI by as much a stage.</summary>
    private const double MaxSlip = 0.5;

    /// <summary>Checks the first two exposures of an image; where they show no ground there is nothing to compare.</summary>
    /// <param name="log">Gets a warning of lines that leave gaps.</param>
    /// <param name="referenceRadius">m: radius of the sphere that the ground is taken for.</param>
    /// <exception cref="BadInputException">The charge of TDI moves another way than the image.</exception>
    public static void Check(Frame frame, ILog log, double referenceRadius)
    {
        if (frame is not { Scan: { Kind: not ScanKind.RollingShutter, Count: > 1 } scan, Model: { } model, Path: { } path }
            || Shift(scan, model, path, referenceRadius) is not (double right, double down))
        {
            return;
        }

        int rows = scan.HeightOf(model) / scan.Count;
        if (Math.Abs(down) > rows + MaxSlip)
        {
            log.Warning(Invariant(
                $"the {(rows == 1 ? "lines" : "framelets")} do not overlap: the ground moves by {Math.Abs(down):G4} rows from one to the "
                    + $"next, which have {rows}. They would touch with --scan-period {scan.Period * rows / Math.Abs(down):G6}."));
        }

        double step = scan.ChargeMovesDown ? 1.0 : -1.0;
        if (scan.Stages > 1 && double.Hypot(right, down - step) > MaxSlip)
        {
            throw new BadInputException(Invariant(
                $"TDI along the wrong axis or at the wrong speed: from line to line the image moves by {right:F2} px to the right and "
                    + $"{down:F2} px down, the charge by {step:F0} px down. Turn the camera, or change 'tdi-direction' or --scan-period."));
        }
    }

    /// <summary>px: how a point of the ground in the middle of the first exposure moves to the next; null without ground.</summary>
    private static (double Right, double Down)? Shift(Scan scan, CameraModel model, ScanPath path, double referenceRadius)
    {
        FrameCamera first = scan.ExposureOf(model, 0, 0.0).At(path.States[0]);
        (double x, double y) = (0.5 * (1.0 + first.Width), 0.5 * (1.0 + first.Height));
        return new ReferenceSphere(referenceRadius).TryFirstHit(first.RayThrough(x, y), out Vector3D point)
            && scan.ExposureOf(model, 1, 0.0).At(path.States[1]).TryProjectPoint(point, out RenderingPoint next)
            ? (next.X - x, next.Y - y)
            : null;
    }
}
