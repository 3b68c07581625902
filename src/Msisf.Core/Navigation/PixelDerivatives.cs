using Msisf.Core.Camera;

namespace Msisf.Core.Navigation;

/// <summary>Partial derivatives of the place at which a point is seen. Each vector holds those by three numbers.</summary>
/// <param name="XByShift">Derivative of x by the camera's position along its own axes (-x forward, y right, z up), px/m.</param>
/// <param name="XByTurn">Derivative of x by turns of the camera about its own axes, right-handed, px/rad.</param>
/// <param name="XByPoint">Derivative of x by the point, body-fixed, px/m.</param>
/// <param name="YByShift">The same of y, px/m.</param>
/// <param name="YByTurn">The same of y, px/rad.</param>
/// <param name="YByPoint">The same of y, px/m.</param>
public readonly record struct PixelDerivatives(
    Vector3D XByShift, Vector3D XByTurn, Vector3D XByPoint, Vector3D YByShift, Vector3D YByTurn, Vector3D YByPoint)
{
    /// <summary>The derivatives at a point in front of a camera.</summary>
    /// <param name="pointBodyFixed">m.</param>
    /// <remarks>
    /// The point is p = M^T (P - C) in camera axes, its tangents are -p.y / p.x to the right and p.z / p.x down. A shift of the camera
    /// changes p by its opposite, a turn w by p x w; the derivatives by w of g . (p x w) are g x p.
    /// </remarks>
    public static PixelDerivatives At(FrameCamera camera, Vector3D pointBodyFixed)
    {
        Vector3D p = camera.MoonFromCamera.Conjugate * (pointBodyFixed - camera.PositionBodyFixed);
        (double Right, double Down) tangents = (-p.Y / p.X, p.Z / p.X);
        (double xByRight, double yByRight) = camera.Model.DirectionInImage(tangents, 1.0, 0.0);
        (double xByDown, double yByDown) = camera.Model.DirectionInImage(tangents, 0.0, 1.0);
        Vector3D right = new(-tangents.Right / p.X, -1.0 / p.X, 0.0);
        Vector3D down = new(-tangents.Down / p.X, 0.0, 1.0 / p.X);
        Vector3D x = (xByRight * right) + (xByDown * down);
        Vector3D y = (yByRight * right) + (yByDown * down);
        UnitQuaternion toMoon = camera.MoonFromCamera;
        return new PixelDerivatives(-x, Vector3D.Cross(x, p), toMoon * x, -y, Vector3D.Cross(y, p), toMoon * y);
    }
}
