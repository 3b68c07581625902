using Msisf.Core.Numerics;

namespace Msisf.Core.Camera;

/// <summary>How wide the beam of a pixel is where it meets something.</summary>
public static class PixelBeam
{
    /// <summary>
    /// m: side of the square that has the area of the pixel's beam across the line of sight. A pixel is a square of side 1 / height
    /// in the image plane at distance f; seen from the focal point, at an angle a off the axis, it covers (1 / (height f))^2 cos^3 a
    /// steradians, to first order in its size; and cos a is depth over range.
    /// </summary>
    /// <param name="camera">The camera.</param>
    /// <param name="ray">The pixel's ray, as <see cref="PinholeCamera.RayThrough"/> has it.</param>
    /// <param name="rayParameter">Where on the ray: origin + parameter times direction.</param>
    public static double SideAt(PinholeCamera camera, Ray ray, double rayParameter) =>
        SideAt(camera, camera.OpticalAxis.Length, ray.Direction, ray.Direction.Length, rayParameter);

    /// <summary>The same, for a caller that knows the length of the ray's direction and its component along the optical axis.</summary>
    internal static double SideAt(
        PinholeCamera camera, double axisLength, Vector3D direction, double directionLength, double rayParameter)
    {
        if (camera.Model.IsThesis)
        {
            double cosine = axisLength / directionLength;
            return rayParameter * Math.Sqrt(cosine) / camera.Height;
        }

        return rayParameter * camera.PixelSide(direction);
    }
}
