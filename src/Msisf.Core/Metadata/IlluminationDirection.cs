using Msisf.Core.Camera;

namespace Msisf.Core.Metadata;

/// <summary>
/// The thesis's "local solar illumination angle" (section 9.3): the direction in the image plane in which the Sun lies along the
/// ground, counter-clockwise from straight down as the viewer sees it (0 down, 90 right, 180 up, 270 degrees left).
/// </summary>
public static class IlluminationDirection
{
    /// <summary>The direction at the ground point that a line of sight shows.</summary>
    /// <param name="camera">Where the line of sight begins; its orientation turns the direction into the image plane.</param>
    /// <param name="lineOfSightBodyFixed">From the camera to the ground point, any length; in the image's half space.</param>
    /// <param name="pointBodyFixed">The ground point, m, on that line; the tangent plane is that of the sphere through it.</param>
    /// <param name="sunPositionBodyFixed">The Sun, or the light that stands for it, m.</param>
    /// <returns>
    /// rad, [0, 2 pi); null where it is undefined: the Sun is in the zenith or nadir of the point, or its ground line is seen end on.
    /// </returns>
    /// <remarks>
    /// The thesis goes 1000 m along the ground towards the Sun and projects that point. A straight line's image is straight, so the
    /// direction at the point itself is the same, is defined even when that second point lies behind the camera, and needs no difference
    /// of two nearby projections: the plane through the line of sight and the ground line cuts the image plane in the wanted direction,
    /// and its normal is one cross product (docs/deviations.md, rows 9 and 10).
    /// </remarks>
    public static double? At(FrameCamera camera, Vector3D lineOfSightBodyFixed, Vector3D pointBodyFixed, Vector3D sunPositionBodyFixed) =>
        At(camera, lineOfSightBodyFixed, lineOfSightBodyFixed.Length, pointBodyFixed, pointBodyFixed.Length, sunPositionBodyFixed);

    /// <summary>The same, for a caller that knows the lengths of the line of sight and of the point's vector, which are not 0.</summary>
    internal static double? At(
        FrameCamera camera, Vector3D lineOfSightBodyFixed, double lineOfSightLength, Vector3D pointBodyFixed, double pointRadius,
        Vector3D sunPositionBodyFixed)
    {
        Vector3D lineOfSight = lineOfSightBodyFixed / lineOfSightLength;

        // The point is taken on the line of sight: rounding moves it aside by 1e-10 m, which would turn the direction to a lamp at a
        // camera 1 m above the ground by 1e-7 degrees.
        double distance = Vector3D.Dot(pointBodyFixed - camera.PositionBodyFixed, lineOfSight);
        Vector3D toSun = sunPositionBodyFixed - camera.PositionBodyFixed - (distance * lineOfSight);
        double sunDistance = toSun.Length;
        if (!(sunDistance > 0.0))
        {
            return null;
        }

        Vector3D zenith = pointBodyFixed / pointRadius;
        Vector3D alongGround = Vector3D.Cross(zenith, Vector3D.Cross(toSun / sunDistance, zenith));
        Vector3D planeNormal = camera.MoonFromCamera.Conjugate * Vector3D.Cross(lineOfSight, alongGround);
        double right = -planeNormal.Z;
        double down = -planeNormal.Y;
        if (double.Hypot(right, down) < Tolerances.IlluminationDirectionSine)
        {
            return null;
        }

        // A lens turns the direction as it turns a short line at the point.
        (right, down) = camera.DirectionInImage(lineOfSightBodyFixed, right, down);
        return AngleReduction.FullTurnOfHalf(Trigonometry.Atan2(right, down));
    }
}
