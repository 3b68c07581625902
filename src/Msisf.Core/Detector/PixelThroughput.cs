using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Parallel;

namespace Msisf.Core.Detector;

/// <summary>How much light each pixel takes: its solid angle times the part of the aperture's area that light from there sees.</summary>
internal static class PixelThroughput
{
    /// <summary>
    /// Computes the throughput of each pixel in steradians. The solid angle is that of the parallelogram between the rays half a pixel to
    /// the left and right, above and below; a flat aperture at an angle t off the axis has the area A cos t. For a pinhole this is
    /// (p / f)^2 cos^4 t.
    /// </summary>
    /// <param name="camera">The camera, in any state.</param>
    /// <param name="isFlatFielded">Whether all pixels get the throughput of a pixel on the axis.</param>
    /// <returns>By rows from the top, each from left to right.</returns>
    public static double[] Of(ICamera camera, bool isFlatFielded, int threads)
    {
        // In camera axes, so that the same camera has the same bits in all frames.
        ICamera inOwnAxes = BandedCamera.Of(
            [.. camera.Bands.Select(band => band.Camera.Model.At(new CameraState(default, UnitQuaternion.Identity)))]);
        double[] throughput = new double[camera.Width * camera.Height];
        if (isFlatFielded)
        {
            CameraModel model = camera.Bands[0].Camera.Model;
            Array.Fill(throughput, 1.0 / (model.FocalX * model.FocalY));
            return throughput;
        }

        WorkerTeam.Run(
            threads,
            camera.Height,
            (_, row) =>
            {
                (PixelRows rows, FrameCamera band) = inOwnAxes.BandAt(row + 1);
                FindRow(band, row + 1 - rows.First, throughput.AsSpan(row * band.Width, band.Width));
            },
            CancellationToken.None);
        return throughput;
    }

    /// <summary>Computes a row, eight pixels at a time: a lens takes as long for one point as for eight.</summary>
    private static void FindRow(FrameCamera camera, double y, Span<double> throughput)
    {
        const double HalfPixel = 0.5;
        VectorRow across = VectorRow.OfLength(Vector512<double>.Count);
        VectorRow down = VectorRow.OfLength(Vector512<double>.Count);
        VectorRow rays = VectorRow.OfLength(Vector512<double>.Count);
        Vector512<double> half = Vector512.Create(HalfPixel);
        Vector512<double> columns = Vector512.Create(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0);
        for (int first = 0; first < throughput.Length; first += Vector512<double>.Count)
        {
            // Behind the last pixel its own place is repeated: farther out a lens may show nothing.
            Vector512<double> x = Vector512.Min(columns + Vector512.Create((double)first), Vector512.Create((double)throughput.Length));
            (camera.DirectionsThrough(x + half, y) - camera.DirectionsThrough(x - half, y)).Store(across, 0);
            (camera.DirectionsThrough(x, y + HalfPixel) - camera.DirectionsThrough(x, y - HalfPixel)).Store(down, 0);
            camera.DirectionsThrough(x, y).Store(rays, 0);
            for (int lane = 0; lane < Vector512<double>.Count && first + lane < throughput.Length; lane++)
            {
                throughput[first + lane] = Of(across[lane], down[lane], rays[lane], camera.ForwardBodyFixed);
            }
        }
    }

    /// <param name="across">Between the rays to the left and right of the pixel.</param>
    /// <param name="down">Between those above and below it.</param>
    private static double Of(Vector3D across, Vector3D down, Vector3D ray, Vector3D forward)
    {
        double length = ray.Length;
        double solidAngle = Math.Abs(Vector3D.Dot(Vector3D.Cross(across, down), ray)) / (length * length * length);
        return solidAngle * Vector3D.Dot(ray, forward) / length;
    }
}
