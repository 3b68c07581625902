using System.Globalization;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;

namespace Msisf.Core.Camera;

/// <summary>
/// The perspective camera of thesis section 8.2, as POV-Ray sees it. Camera axes: it looks along -x, y is to the right,
/// z is up; the user's quaternion turns camera axes into Moon axes (chapter 7; docs/deviations.md, row 7).
/// </summary>
public sealed class PinholeCamera
{
    private readonly double _imagePlaneDistance;

    /// <summary>Places the camera.</summary>
    /// <param name="positionMoonMe">Focal point, m, MOON_ME.</param>
    /// <param name="moonFromCamera">Orientation.</param>
    /// <param name="fieldOfView">Horizontal field of view, rad, from <see cref="Tolerances.MinFieldOfView"/> to below pi.</param>
    /// <param name="width">Image width, px, at least 1.</param>
    /// <param name="height">Image height, px, at least 1.</param>
    /// <exception cref="BadInputException">The field of view is out of range, or the position's length is not finite.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A size is below 1.</exception>
    /// <exception cref="ArgumentException">The orientation is <c>default</c>, which is no rotation.</exception>
    public PinholeCamera(Vector3D positionMoonMe, UnitQuaternion moonFromCamera, double fieldOfView, int width, int height)
    {
        if (!(fieldOfView >= Tolerances.MinFieldOfView && fieldOfView < Math.PI))
        {
            throw new BadInputException(
                $"The field of view is {Degrees(fieldOfView)} degrees; it must lie between {Degrees(Tolerances.MinFieldOfView)} and 180 "
                    + $"degrees.");
        }

        if (!double.IsFinite(positionMoonMe.Length))
        {
            throw new BadInputException($"The camera position {positionMoonMe} m is not finite, or farther away than numbers reach.");
        }

        ArgumentOutOfRangeException.ThrowIfLessThan(width, 1);
        ArgumentOutOfRangeException.ThrowIfLessThan(height, 1);

        if (moonFromCamera == default)
        {
            throw new ArgumentException("The default quaternion is no rotation.", nameof(moonFromCamera));
        }

        PositionMoonMe = positionMoonMe;
        MoonFromCamera = moonFromCamera;
        FieldOfView = fieldOfView;
        Width = width;
        Height = height;

        double aspect = (double)width / height;
        ForwardMoonMe = moonFromCamera * -Vector3D.UnitX;
        Right = aspect * (moonFromCamera * Vector3D.UnitY);
        Up = moonFromCamera * Vector3D.UnitZ;
        _imagePlaneDistance = aspect / 2.0 / Math.Tan(fieldOfView / 2.0);
        Direction = _imagePlaneDistance * ForwardMoonMe;

        double right = Math.Tan(fieldOfView / 2.0);
        PixelTangent = 2.0 * right / width;
        double up = 0.5 * height * PixelTangent;
        Footprint = new PixelFootprint(positionMoonMe, ForwardMoonMe, PixelTangent, 1.0 / Math.Sqrt(1.0 + (right * right) + (up * up)));
    }

    /// <summary>Focal point, m, MOON_ME.</summary>
    public Vector3D PositionMoonMe { get; }

    /// <summary>Orientation: turns camera axes into Moon axes.</summary>
    public UnitQuaternion MoonFromCamera { get; }

    /// <summary>Horizontal field of view, rad.</summary>
    public double FieldOfView { get; }

    /// <summary>Image width, px.</summary>
    public int Width { get; }

    /// <summary>Image height, px.</summary>
    public int Height { get; }

    /// <summary>Viewing direction of length 1, MOON_ME.</summary>
    public Vector3D ForwardMoonMe { get; }

    /// <summary>POV-Ray's direction vector, MOON_ME, length aspect / (2 tan(fov / 2)) (thesis eq. 8.10).</summary>
    public Vector3D Direction { get; }

    /// <summary>POV-Ray's right vector, MOON_ME, length width / height (thesis eq. 8.8).</summary>
    public Vector3D Right { get; }

    /// <summary>POV-Ray's up vector, MOON_ME, length 1 (thesis eq. 8.11).</summary>
    public Vector3D Up { get; }

    /// <summary>Tangent of the angle of a pixel in the middle of the image; pixels are square.</summary>
    public double PixelTangent { get; }

    /// <summary>The width that the pixels cover at a distance.</summary>
    public PixelFootprint Footprint { get; }

    /// <summary>
    /// The ray through a point of the image plane in rendering coordinates: pixel (x, y) from 1, x right, y down (thesis eq. 8.15).
    /// </summary>
    /// <param name="x">Rendering coordinate; whole numbers are pixel centres.</param>
    /// <param name="y">Rendering coordinate.</param>
    public Ray RayThrough(double x, double y)
    {
        double up = (1.0 + Height - (2.0 * y)) / (2.0 * Height);
        double right = ((2.0 * x) - 1.0 - Width) / (2.0 * Width);
        return new Ray(PositionMoonMe, Direction + (up * Up) + (right * Right));
    }

    /// <summary>Where the line from the focal point along a direction meets the image plane.</summary>
    /// <param name="directionMoonMe">From the focal point, MOON_ME, any length.</param>
    /// <param name="point">Rendering coordinates; (0, 0) if there are none.</param>
    /// <returns>False for a direction that does not lead forward through the image plane.</returns>
    /// <remarks>
    /// Decomposed on right and up: the products of thesis eq. 9.20 cancel, which cost the published angles 5e-5 degrees
    /// (docs/deviations.md, row 10).
    /// </remarks>
    public bool TryProject(Vector3D directionMoonMe, out RenderingPoint point)
    {
        Vector3D inCamera = MoonFromCamera.Conjugate * directionMoonMe;

        // One unit of the image plane is Height px in both directions: Right spans aspect units and Width px.
        double scale = Height * _imagePlaneDistance / -inCamera.X;
        double x = ((1.0 + Width) / 2.0) + (scale * inCamera.Y);
        double y = ((1.0 + Height) / 2.0) - (scale * inCamera.Z);
        bool isInFront = scale > 0.0 && double.IsFinite(x) && double.IsFinite(y);
        point = isInFront ? new RenderingPoint(x, y) : default;
        return isInFront;
    }

    private static string Degrees(double angle) =>
        double.RadiansToDegrees(angle).ToString("R", CultureInfo.InvariantCulture);
}
