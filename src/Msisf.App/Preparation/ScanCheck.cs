using Msisf.App.Host;
using Msisf.Core.Camera;
using Msisf.Core.Tracing;

namespace Msisf.App.Preparation;

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
