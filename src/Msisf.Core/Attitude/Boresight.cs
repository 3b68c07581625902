using Msisf.Core.Terrain;

namespace Msisf.Core.Attitude;

/// <summary>
/// Lines of sight and the attitudes that look along them. East and north are those of <see cref="NadirPointing"/>, also over the poles.
/// </summary>
public static class Boresight
{
    /// <summary>The direction from a camera to a point.</summary>
    /// <param name="positionBodyFixed">Camera, m, body-fixed.</param>
    /// <param name="targetBodyFixed">Point, m, body-fixed.</param>
    /// <returns>Length 1, body-fixed.</returns>
    /// <exception cref="BadInputException">The camera is at the point.</exception>
    public static Vector3D Towards(Vector3D positionBodyFixed, Vector3D targetBodyFixed)
    {
        Vector3D line = targetBodyFixed - positionBodyFixed;
        return line.Length > 0.0
            ? line.Normalized()
            : throw new BadInputException("The camera is at the very point that it is to look at. Move one of them.");
    }

    /// <summary>The direction at an angle from the nadir.</summary>
    /// <param name="positionBodyFixed">Camera, m, body-fixed.</param>
    /// <param name="offNadir">rad, from the nadir; pi looks up.</param>
    /// <param name="azimuth">rad, clockwise from north, as on a map.</param>
    /// <returns>Length 1, body-fixed.</returns>
    public static Vector3D OffNadir(Vector3D positionBodyFixed, double offNadir, double azimuth)
    {
        UnitQuaternion nadir = NadirPointing.MoonFromCamera(positionBodyFixed);
        (double sinAngle, double cosAngle) = Trigonometry.SinCos(offNadir);
        (double sinAzimuth, double cosAzimuth) = Trigonometry.SinCos(azimuth);
        return nadir * new Vector3D(-cosAngle, sinAngle * sinAzimuth, sinAngle * cosAzimuth);
    }

    /// <summary>
    /// The direction to the horizon: the line from the camera that touches the reference sphere. Inside the sphere it is level.
    /// </summary>
    /// <param name="positionBodyFixed">Camera, m, body-fixed.</param>
    /// <param name="azimuth">rad, clockwise from north.</param>
    /// <param name="radius">m: radius of the reference sphere.</param>
    /// <returns>Length 1, body-fixed.</returns>
    public static Vector3D Horizon(Vector3D positionBodyFixed, double azimuth, double radius = MoonConstants.ReferenceRadius)
    {
        double height = positionBodyFixed.Length - radius;
        double toHorizon = Math.Sqrt(Math.Max(0.0, height * (height + (2.0 * radius))));
        return OffNadir(positionBodyFixed, Trigonometry.Atan2(radius, toHorizon), azimuth);
    }

    /// <summary>The attitude that looks along a direction.</summary>
    /// <param name="positionBodyFixed">Camera, m, body-fixed.</param>
    /// <param name="forwardBodyFixed">Line of sight, length 1, body-fixed.</param>
    /// <param name="upBodyFixed">
    /// What points up in the image, body-fixed, any length. Where it is parallel to the line of sight, north does, and where that is
    /// parallel too, the zenith.
    /// </param>
    /// <param name="roll">rad: turns the camera about its line of sight, clockwise as seen from behind it.</param>
    /// <returns>Turns camera axes (looks along -x, y right, z up) into Moon axes.</returns>
    public static UnitQuaternion MoonFromCamera(Vector3D positionBodyFixed, Vector3D forwardBodyFixed, Vector3D upBodyFixed, double roll)
    {
        Vector3D north = NadirPointing.MoonFromCamera(positionBodyFixed) * Vector3D.UnitZ;
        Vector3D[] choices = [upBodyFixed, north, positionBodyFixed];
        Vector3D right = choices.Select(up => Vector3D.Cross(forwardBodyFixed, up.Normalized())).First(
            across => across.Length > Tolerances.UpAlongBoresight).Normalized();
        Vector3D up = Vector3D.Cross(right, forwardBodyFixed);
        UnitQuaternion moonFromCamera = UnitQuaternion.FromMatrix(new RotationMatrix(-forwardBodyFixed, right, up).Transposed);
        return roll == 0.0 ? moonFromCamera : moonFromCamera * UnitQuaternion.FromAxisAngle(-Vector3D.UnitX, roll);
    }
}

/// <summary>What a camera looks at.</summary>
public enum BoresightKind
{
    /// <summary>The Moon's centre; the default.</summary>
    Nadir,

    /// <summary>A place on, above or below the surface.</summary>
    Place,

    /// <summary>The Sun.</summary>
    Sun,

    /// <summary>The horizon of the reference sphere in an azimuth.</summary>
    Horizon,

    /// <summary>At an angle from the nadir, towards an azimuth.</summary>
    OffNadir,
}
