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
                for (int column = 0; column < band.Width; column++)
                {
                    throughput[(row * band.Width) + column] = At(band, column + 1, row + 1 - rows.First);
                }
            },
            CancellationToken.None);
        return throughput;
    }

    private static double At(FrameCamera camera, double x, double y)
    {
        const double HalfPixel = 0.5;
        Vector3D across = camera.RayThrough(x + HalfPixel, y).Direction - camera.RayThrough(x - HalfPixel, y).Direction;
        Vector3D down = camera.RayThrough(x, y + HalfPixel).Direction - camera.RayThrough(x, y - HalfPixel).Direction;
        Vector3D ray = camera.RayThrough(x, y).Direction;
        double length = ray.Length;
        double solidAngle = Math.Abs(Vector3D.Dot(Vector3D.Cross(across, down), ray)) / (length * length * length);
        return solidAngle * Vector3D.Dot(ray, camera.ForwardBodyFixed) / length;
    }
}
