using Msisf.Core.Camera;

namespace Msisf.Core.Navigation;

/// <summary>
/// The disc of a crater's rim: in the plane through its centre at right angles to the radius there. MOON_ME, m. <c>default</c> is none.
/// </summary>
/// <param name="Centre">On the terrain.</param>
/// <param name="Up">Normal of length 1, away from the Moon's centre.</param>
/// <param name="Major">From the centre along the major axis to the rim.</param>
/// <param name="Minor">Along the minor axis, 90 degrees counter-clockwise as seen from above.</param>
public readonly record struct CraterDisc(Vector3D Centre, Vector3D Up, Vector3D Major, Vector3D Minor)
{
    /// <summary>The disc of a crater.</summary>
    /// <param name="radius">m from the Moon's centre to the ground in the middle of the crater.</param>
    public static CraterDisc Of(Crater crater, double radius)
    {
        (double sinLatitude, double cosLatitude) = Trigonometry.SinCos(double.DegreesToRadians(crater.LatitudeDegrees));
        (double sinLongitude, double cosLongitude) = Trigonometry.SinCos(double.DegreesToRadians(crater.LongitudeDegrees));
        Vector3D up = new(cosLatitude * cosLongitude, cosLatitude * sinLongitude, sinLatitude);
        Vector3D east = new(-sinLongitude, cosLongitude, 0.0);
        Vector3D north = new(-sinLatitude * cosLongitude, -sinLatitude * sinLongitude, cosLatitude);
        (double sin, double cos) = Trigonometry.SinCos(double.DegreesToRadians(crater.AngleDegrees));
        return new CraterDisc(
            radius * up,
            up,
            0.5 * crater.Diameter * ((cos * east) + (sin * north)),
            0.5 * crater.MinorDiameter * ((cos * north) - (sin * east)));
    }

    /// <summary>A point of the rim.</summary>
    /// <param name="anomaly">rad from the major axis.</param>
    public Vector3D RimAt(double anomaly)
    {
        (double sin, double cos) = Trigonometry.SinCos(anomaly);
        return Centre + ((cos * Major) + (sin * Minor));
    }

    /// <summary>Whether a position lies above the disc's plane, so that it sees the disc's upper side.</summary>
    public bool IsBelow(Vector3D positionBodyFixed) => Vector3D.Dot(positionBodyFixed - Centre, Up) > 0.0;

    /// <summary>
    /// Whether a surface point that a camera above the disc sees inside of the rim's ellipse hides the disc: it lies above the disc's
    /// plane, so nearer, and not over the disc. The crater's own walls over the disc do not hide it.
    /// </summary>
    public bool IsHiddenBy(Vector3D pointBodyFixed)
    {
        Vector3D way = pointBodyFixed - Centre;
        if (!(Vector3D.Dot(way, Up) > 0.0))
        {
            return false;
        }

        double along = Vector3D.Dot(way, Major) / Major.LengthSquared;
        double across = Vector3D.Dot(way, Minor) / Minor.LengthSquared;
        return (along * along) + (across * across) > 1.0;
    }

    /// <summary>The ellipse of the rim in the image of a pinhole.</summary>
    /// <param name="camera">Without a lens.</param>
    /// <returns>False if the rim crosses or touches the camera's plane, so that it is seen as a hyperbola, or lies behind it.</returns>
    /// <remarks>
    /// J. A. Christian, H. Derksen, R. Watkins, "Lunar crater identification in digital images", J. Astronaut. Sci. 68 (2021) 1056: a disc
    /// is seen as a conic by the camera's projective map. Here the rim C + U cos + V sin in camera axes is seen at
    /// c + (u cos + v sin) / (Cz + Uz cos + Vz sin), with c the image of the centre and u = Uxy - c Uz. The centre of the ellipse is
    /// c + m, m = -(Uz u + Vz v) / D, its shape (u u^T + v v^T) / D + m m^T, D = Cz^2 - Uz^2 - Vz^2. Nothing cancels: no matrix of a conic
    /// with numbers of 1e12 is inverted.
    /// </remarks>
    public bool TryProject(FrameCamera camera, out ImageEllipse ellipse)
    {
        CameraModel model = camera.Model;
        Vector3D centre = InCamera(camera, Centre - camera.PositionBodyFixed);
        Vector3D major = InCamera(camera, Major);
        Vector3D minor = InCamera(camera, Minor);
        double towards = double.Hypot(major.Z, minor.Z);
        if (!(centre.Z > towards))
        {
            ellipse = default;
            return false;
        }

        (double right, double down) = (centre.X / centre.Z, centre.Y / centre.Z);
        double depths = (centre.Z - towards) * (centre.Z + towards);
        double root = Math.Sqrt(depths);
        (double X, double Y) u = ToImage(model, major.X - (right * major.Z), major.Y - (down * major.Z));
        (double X, double Y) v = ToImage(model, minor.X - (right * minor.Z), minor.Y - (down * minor.Z));
        (double X, double Y) shift =
            (-((major.Z * u.X) + (minor.Z * v.X)) / depths, -((major.Z * u.Y) + (minor.Z * v.Y)) / depths);
        (double X, double Y) middle = ToImage(model, right, down);
        ellipse = ImageEllipse.OfShape(
            model.PrincipalX + middle.X + shift.X,
            model.PrincipalY + middle.Y + shift.Y,
            [(u.X / root, u.Y / root), (v.X / root, v.Y / root), shift]);
        return double.IsFinite(ellipse.X) && double.IsFinite(ellipse.Y) && double.IsFinite(ellipse.SemiMajor) && ellipse.SemiMinor > 0.0;
    }

    /// <summary>Right, down, forward.</summary>
    private static Vector3D InCamera(FrameCamera camera, Vector3D vector) => new(
        Vector3D.Dot(vector, camera.UnitRight), -Vector3D.Dot(vector, camera.UnitUp), Vector3D.Dot(vector, camera.ForwardBodyFixed));

    private static (double X, double Y) ToImage(CameraModel model, double right, double down) =>
        ((model.FocalX * right) + (model.Skew * down), model.FocalY * down);
}
