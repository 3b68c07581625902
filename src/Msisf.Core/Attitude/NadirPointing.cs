namespace Msisf.Core.Attitude;

/// <summary>The attitude that looks straight down with north up.</summary>
public static class NadirPointing
{
    /// <summary>
    /// The camera looks at the Moon's centre, right is east and up is north. Over a pole these are the limits along the meridian
    /// of atan2(y, x); on the polar axis itself, along the meridian 0.
    /// </summary>
    /// <param name="positionBodyFixed">m, body-fixed.</param>
    /// <returns>Turns camera axes (looks along -x, y right, z up) into Moon axes.</returns>
    /// <exception cref="BadInputException">The position is the Moon's centre, where there is no down, or not finite.</exception>
    /// <remarks>The thesis gives no formula: docs/deviations.md, row 19.</remarks>
    public static UnitQuaternion MoonFromCamera(Vector3D positionBodyFixed)
    {
        if (!positionBodyFixed.IsFinite)
        {
            throw new BadInputException("The position (m) is not finite; nadir pointing needs three finite numbers.");
        }

        double horizontal = double.Hypot(positionBodyFixed.X, positionBodyFixed.Y);
        if (horizontal == 0.0 && positionBodyFixed.Z == 0.0)
        {
            throw new BadInputException(
                "The spacecraft is in the Moon's centre, where no direction is nadir; give an attitude or another position.");
        }

        // Without the test, atan2 of two signed zeros may be pi.
        double longitude = horizontal == 0.0 ? 0.0 : Trigonometry.Atan2(positionBodyFixed.Y, positionBodyFixed.X);
        double latitude = Trigonometry.Atan2(positionBodyFixed.Z, horizontal);
        return UnitQuaternion.FromAxisAngle(Vector3D.UnitZ, longitude) * UnitQuaternion.FromAxisAngle(Vector3D.UnitY, -latitude);
    }

    /// <summary>How fast a camera with that attitude turns over the body.</summary>
    /// <param name="positionBodyFixed">m; not the centre.</param>
    /// <param name="velocityBodyFixed">m/s over the turning body.</param>
    /// <returns>rad/s about the camera's axes; on the polar axis, where the longitude jumps, as if it did not.</returns>
    public static Vector3D RateOf(Vector3D positionBodyFixed, Vector3D velocityBodyFixed)
    {
        (Vector3D at, Vector3D by) = (positionBodyFixed, velocityBodyFixed);
        UnitQuaternion moonFromCamera = MoonFromCamera(at);
        double horizontal = double.Hypot(at.X, at.Y);
        double eastwards = horizontal == 0.0 ? 0.0 : ((at.X * by.Y) - (at.Y * by.X)) / (horizontal * horizontal);
        double northwards = Vector3D.Dot(moonFromCamera * Vector3D.UnitZ, by) / at.Length; // up in the image is north
        return (moonFromCamera.Conjugate * (eastwards * Vector3D.UnitZ)) - (northwards * Vector3D.UnitY);
    }
}
