using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;

namespace Msisf.Core.Tests.Render.Indirect;

/// <summary>Views straight down on the ground of a <see cref="PlaneGrid"/>.</summary>
internal static class PlaneView
{
    /// <summary>m: the sphere that the plane touches.</summary>
    public const double Radius = 1_737_400.0;

    /// <summary>m over the plane: of the camera.</summary>
    public const double Height = 20_000.0;

    /// <summary>Lambert's law.</summary>
    /// <param name="albedo">Of the whole ground.</param>
    public static NativeRenderOptions Options(double albedo) =>
        new() { Reflectance = new LambertReflectance(albedo), KeepGroundTruth = true };

    /// <summary>Draws the ground around the pole.</summary>
    /// <param name="grid">The ground.</param>
    /// <param name="elevation">Degrees, of the Sun; it stands over x.</param>
    /// <param name="side">Pixels.</param>
    /// <param name="options">The settings.</param>
    /// <param name="threads">Number of threads.</param>
    /// <param name="width">m: of the plane in the image.</param>
    public static NativeFrame Draw(
        ITerrainGrid grid, double elevation, int side, NativeRenderOptions options, int threads = 2, double width = PlaneGrid.Diameter)
    {
        (double sine, double cosine) = Math.SinCos(double.DegreesToRadians(elevation));
        PinholeCamera camera = new(
            new Vector3D(0.0, 0.0, Radius + Height), CameraCases.Attitude(-Vector3D.UnitZ, Vector3D.UnitY),
            2.0 * Math.Atan(0.5 * width / Height), side, side);
        SceneLight sun = new(new Vector3D(1.5e11 * cosine, 0.0, Radius + (1.5e11 * sine)), IsSun: true);
        return new NativeRenderer(grid).Render(camera, sun, options, threads);
    }

    /// <summary>The pixels that see ground around the pole.</summary>
    /// <param name="frame">The image.</param>
    /// <param name="radius">m: so far from the pole.</param>
    public static IEnumerable<(int Pixel, SurfaceHit Hit, PixelIllumination Light)> Within(NativeFrame frame, double radius)
    {
        for (int pixel = 0; pixel < frame.Camera.Width * frame.Camera.Height; pixel++)
        {
            (int x, int y) = ((pixel % frame.Camera.Width) + 1, (pixel / frame.Camera.Width) + 1);
            if (frame.TryGet(x, y, out SurfaceHit hit, out PixelIllumination light)
                && double.Hypot(hit.PointBodyFixed.X, hit.PointBodyFixed.Y) < radius)
            {
                yield return (pixel, hit, light);
            }
        }
    }

    /// <summary>The contour formula of J. H. Lambert: the part of a point's hemisphere that an area of even brightness is worth.</summary>
    /// <param name="corners">m: of the area, from the point, all of them over its horizon.</param>
    /// <param name="normal">Of the point.</param>
    public static double PartOf(Vector3D[] corners, Vector3D normal)
    {
        double sum = 0.0;
        for (int corner = 0; corner < corners.Length; corner++)
        {
            (Vector3D one, Vector3D next) = (corners[corner], corners[(corner + 1) % corners.Length]);
            sum += Vector3D.AngleBetween(one, next) * Vector3D.Dot(Vector3D.Cross(one, next).Normalized(), normal);
        }

        return Math.Abs(sum) / (2.0 * Math.PI);
    }
}
