using Msisf.Core.Camera;
using Msisf.Core.Parallel;
using Msisf.Core.Render;
using Msisf.Core.Tracing;

namespace Msisf.Core.Detector;

/// <summary>How fast the image moves over the detector while a camera moves.</summary>
/// <remarks>
/// The velocity of an image point is a straight line in the inverse of its depth, so between two depths its length is greatest at one of
/// them. Each block of pixels is therefore followed at its corners for the least and greatest depth of all that its pixels show.
/// </remarks>
internal static class ImageMotion
{
    private const int BlockSide = 32; // px: the speed changes little over it
    private const int MinSegments = 4; // each half of the time has two, so that the change of speed is seen
    private const double MaxTurn = 0.1; // rad: in a segment of this angle a path differs from its chord by 4e-4 of its length

    /// <summary>The greatest motion in a time, if it went on all the time as it does where it is fastest.</summary>
    /// <param name="frame">The frame at the middle of the time, with ground truth.</param>
    /// <param name="span">s.</param>
    /// <param name="maxSegments">Into how many parts the time may be cut to follow the points.</param>
    /// <param name="threads">Number of threads; the result does not depend on it.</param>
    /// <returns>px; infinite if it can't be followed.</returns>
    public static double Greatest(
        NativeFrame frame, CameraMotion motion, double span, int maxSegments, int threads, CancellationToken cancellation)
    {
        double turn = motion.AngularVelocityCamera.Length * span;
        if (!(turn <= MaxTurn * maxSegments))
        {
            return double.PositiveInfinity;
        }

        int segments = Math.Max(MinSegments, 2 * (int)Math.Ceiling(0.5 * turn / MaxTurn));
        ICamera[] cameras = [.. Enumerable.Range(0, segments + 1).Select(
            index => frame.Camera.Moved(motion, ((double)index / segments - 0.5) * span))];
        int blocks = (frame.Camera.Height + BlockSide - 1) / BlockSide;
        double[] greatest = new double[blocks];
        WorkerTeam.Run(threads, blocks, (_, block) =>
        {
            int top = 1 + (block * BlockSide);
            int bottom = Math.Min(frame.Camera.Height, top + BlockSide - 1);
            for (int left = 1; left <= frame.Camera.Width; left += BlockSide)
            {
                int right = Math.Min(frame.Camera.Width, left + BlockSide - 1);
                greatest[block] = Math.Max(greatest[block], OfBlock(frame, cameras, (left, right), (top, bottom)));
            }
        }, cancellation);
        return segments * greatest.Max();
    }

    private static double OfBlock(NativeFrame frame, ICamera[] cameras, (int First, int Last) columns, (int First, int Last) rows)
    {
        (double nearest, double farthest) = Depths(frame, columns, rows);
        double greatest = 0.0;
        foreach ((double x, double y) in (ReadOnlySpan<(double, double)>)[
            (columns.First - 0.5, rows.First - 0.5), (columns.Last + 0.5, rows.First - 0.5), (columns.First - 0.5, rows.Last + 0.5),
            (columns.Last + 0.5, rows.Last + 0.5)])
        {
            Ray ray = frame.Camera.RayThrough(x, y);
            Vector3D direction = ray.Direction / frame.Camera.BandAt(y).Camera.ImagePlaneDistance; // of depth 1
            greatest = Math.Max(greatest, OfPoint(cameras, ray.Origin + (nearest * direction)));
            greatest = Math.Max(greatest, OfPoint(cameras, ray.Origin + (farthest * direction)));
        }

        return greatest;
    }

    /// <summary>
    /// Least and greatest depth, along the optical axis, of what the pixels show; the distance of the Moon's centre where they show no
    /// surface.
    /// </summary>
    private static (double Nearest, double Farthest) Depths(
        NativeFrame frame, (int First, int Last) columns, (int First, int Last) rows)
    {
        (double nearest, double farthest) = (double.PositiveInfinity, 0.0);
        for (int y = rows.First; y <= rows.Last; y++)
        {
            FrameCamera camera = frame.Camera.BandAt(y).Camera;
            for (int x = columns.First; x <= columns.Last; x++)
            {
                if (frame.TryGetSurface(x, y, out SurfaceHit hit))
                {
                    double depth = Vector3D.Dot(hit.PointBodyFixed - camera.PositionBodyFixed, camera.ForwardBodyFixed);
                    nearest = Math.Min(nearest, depth);
                    farthest = Math.Max(farthest, depth);
                }
            }
        }

        double centre = frame.Camera.PositionBodyFixed.Length;
        return farthest > 0.0 ? (nearest, farthest) : (centre, centre);
    }

    /// <summary>The greatest motion of a point from one camera to the next, px, while one of them shows it.</summary>
    private static double OfPoint(ICamera[] cameras, Vector3D pointBodyFixed)
    {
        double greatest = 0.0;
        (double X, double Y)? before = ImageOf(cameras[0], pointBodyFixed);
        foreach (ICamera camera in cameras.AsSpan(1))
        {
            (double X, double Y)? after = ImageOf(camera, pointBodyFixed);
            if (IsInside(camera, before) || IsInside(camera, after))
            {
                greatest = before is { } from && after is { } to
                    ? Math.Max(greatest, double.Hypot(to.X - from.X, to.Y - from.Y))
                    : double.PositiveInfinity;
            }

            before = after;
        }

        return greatest;
    }

    private static (double X, double Y)? ImageOf(ICamera camera, Vector3D pointBodyFixed) =>
        camera.TryProjectPoint(pointBodyFixed, out RenderingPoint point) ? (point.X, point.Y) : null;

    private static bool IsInside(ICamera camera, (double X, double Y)? point) => point is (double x, double y)
        && x >= 0.0 && x <= camera.Width + 1.0 && y >= 0.0 && y <= camera.Height + 1.0;
}
