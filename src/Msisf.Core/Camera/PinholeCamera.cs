using Msisf.Core.Errors;
using Msisf.Core.Numerics;

namespace Msisf.Core.Camera;

/// <summary>
/// The perspective camera of thesis section 8.2, as POV-Ray sees it, or one with a principal point and a lens of its own. Camera axes: it
/// looks along -x, y is to the right, z is up; the user's quaternion turns camera axes into Moon axes (chapter 7; docs/deviations.md,
/// row 7).
/// </summary>
public sealed class PinholeCamera
{
    private readonly double _imagePlaneDistance;

    /// <summary>Places the camera of the thesis.</summary>
    /// <param name="positionMoonMe">Focal point, m, MOON_ME.</param>
    /// <param name="moonFromCamera">Orientation.</param>
    /// <param name="fieldOfView">Horizontal field of view, rad, from <see cref="Tolerances.MinFieldOfView"/> to below pi.</param>
    /// <param name="width">Image width, px, at least 1.</param>
    /// <param name="height">Image height, px, at least 1.</param>
    /// <exception cref="BadInputException">The field of view is out of range, or the position's length is not finite.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A size is below 1.</exception>
    /// <exception cref="ArgumentException">The orientation is <c>default</c>, which is no rotation.</exception>
    public PinholeCamera(Vector3D positionMoonMe, UnitQuaternion moonFromCamera, double fieldOfView, int width, int height)
        : this(positionMoonMe, moonFromCamera, CameraModel.FromFieldOfView(fieldOfView, width, height))
    {
    }

    /// <summary>Places a camera.</summary>
    /// <param name="positionMoonMe">Focal point, m, MOON_ME.</param>
    /// <param name="moonFromCamera">Orientation.</param>
    /// <param name="model">Size, focal length, principal point and distortion.</param>
    /// <exception cref="BadInputException">The position's length is not finite.</exception>
    /// <exception cref="ArgumentException">The orientation is <c>default</c>, which is no rotation.</exception>
    public PinholeCamera(Vector3D positionMoonMe, UnitQuaternion moonFromCamera, CameraModel model)
    {
        if (!double.IsFinite(positionMoonMe.Length))
        {
            throw new BadInputException($"The camera position {positionMoonMe} m is not finite, or farther away than numbers reach.");
        }

        if (moonFromCamera == default)
        {
            throw new ArgumentException("The default quaternion is no rotation.", nameof(moonFromCamera));
        }

        Model = model;
        PositionMoonMe = positionMoonMe;
        MoonFromCamera = moonFromCamera;
        ForwardMoonMe = moonFromCamera * -Vector3D.UnitX;
        UnitRight = moonFromCamera * Vector3D.UnitY;
        UnitUp = moonFromCamera * Vector3D.UnitZ;
        if (model.IsThesis)
        {
            double aspect = (double)Width / Height;
            Right = aspect * UnitRight;
            Up = UnitUp;
            _imagePlaneDistance = aspect / 2.0 / Math.Tan(FieldOfView / 2.0);
            Direction = _imagePlaneDistance * ForwardMoonMe;

            double right = Math.Tan(FieldOfView / 2.0);
            PixelTangent = 2.0 * right / Width;
            double up = 0.5 * Height * PixelTangent;
            Footprint = new PixelFootprint(
                positionMoonMe, ForwardMoonMe, PixelTangent, 1.0 / Math.Sqrt(1.0 + (right * right) + (up * up)));
            return;
        }

        // The axes of POV-Ray for a pinhole of any kind: up again has the length of the image's height, but for the skew.
        _imagePlaneDistance = model.FocalY / Height;
        double shear = model.Skew / model.FocalX;
        double middleDown = ((0.5 * (1.0 + Height)) - model.PrincipalY) / model.FocalY;
        double middleRight = (((0.5 * (1.0 + Width)) - model.PrincipalX) / model.FocalX) - (shear * middleDown);
        Right = _imagePlaneDistance * Width / model.FocalX * UnitRight;
        Up = UnitUp + (shear * UnitRight);
        Direction = _imagePlaneDistance * (ForwardMoonMe + (middleRight * UnitRight) - (middleDown * UnitUp));
        PixelTangent = model.MinPixelTangent();
        double border = model.BorderTangent();
        Footprint = new PixelFootprint(positionMoonMe, ForwardMoonMe, PixelTangent, 1.0 / Math.Sqrt(1.0 + (border * border)));
    }

    /// <summary>Size, focal length, principal point and distortion.</summary>
    public CameraModel Model { get; }

    /// <summary>Focal point, m, MOON_ME.</summary>
    public Vector3D PositionMoonMe { get; }

    /// <summary>Orientation: turns camera axes into Moon axes.</summary>
    public UnitQuaternion MoonFromCamera { get; }

    /// <summary>Horizontal field of view, rad.</summary>
    public double FieldOfView => Model.FieldOfView;

    /// <summary>Image width, px.</summary>
    public int Width => Model.Width;

    /// <summary>Image height, px.</summary>
    public int Height => Model.Height;

    /// <summary>Viewing direction of length 1, MOON_ME.</summary>
    public Vector3D ForwardMoonMe { get; }

    /// <summary>To the right in the image along its rows, MOON_ME, length 1, perpendicular to the viewing direction.</summary>
    public Vector3D UnitRight { get; }

    /// <summary>Up, MOON_ME, length 1, perpendicular to the viewing direction and to the right.</summary>
    public Vector3D UnitUp { get; }

    /// <summary>
    /// POV-Ray's direction vector, MOON_ME: of the thesis's camera the viewing direction with length aspect / (2 tan(fov / 2)) (thesis eq.
    /// 8.10), of others towards the middle of the image without distortion.
    /// </summary>
    public Vector3D Direction { get; }

    /// <summary>POV-Ray's right vector, MOON_ME: the image's width without distortion; of the thesis's camera of length width / height (eq.
    /// 8.8).</summary>
    public Vector3D Right { get; }

    /// <summary>
    /// POV-Ray's up vector, MOON_ME: the image's height without distortion; of the thesis's camera of length 1 (eq. 8.11).
    /// </summary>
    public Vector3D Up { get; }

    /// <summary>Component of each ray's direction along the viewing direction.</summary>
    public double ImagePlaneDistance => _imagePlaneDistance;

    /// <summary>
    /// Direction of the ray along the optical axis, MOON_ME: the part along the axis of each ray's direction. <see cref="Direction"/> leads
    /// elsewhere where the principal point is not in the middle, and is longer.
    /// </summary>
    internal Vector3D OpticalAxis => _imagePlaneDistance * ForwardMoonMe;

    /// <summary>Change of the direction of a ray with the tangent to the right, for a camera with a lens.</summary>
    internal Vector3D LensRight => _imagePlaneDistance * UnitRight;

    /// <summary>Change of the direction of a ray with the tangent down, for a camera with a lens.</summary>
    internal Vector3D LensDown => -_imagePlaneDistance * UnitUp;

    /// <summary>Tangent of the angle of a pixel in the middle of the image, or of the smallest pixel if they differ.</summary>
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
        if (Model.Lens is not null)
        {
            (double idealRight, double idealDown) = Model.ToIdeal(x, y);
            return new Ray(PositionMoonMe, OpticalAxis + (idealRight * LensRight) + (idealDown * LensDown));
        }

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
        if (!Model.IsThesis)
        {
            point = default;
            return -inCamera.X > 0.0 && Model.TryToImage(inCamera.Y / -inCamera.X, inCamera.Z / inCamera.X, out point);
        }

        // One unit of the image plane is Height px in both directions: Right spans aspect units and Width px.
        double scale = Height * _imagePlaneDistance / -inCamera.X;
        double x = ((1.0 + Width) / 2.0) + (scale * inCamera.Y);
        double y = ((1.0 + Height) / 2.0) - (scale * inCamera.Z);
        bool isInFront = scale > 0.0 && double.IsFinite(x) && double.IsFinite(y);
        point = isInFront ? new RenderingPoint(x, y) : default;
        return isInFront;
    }

    /// <summary>Side of the square with the area of a pixel's beam across its ray, where the ray's parameter is 1.</summary>
    /// <param name="lineOfSightMoonMe">The pixel's ray, as <see cref="RayThrough"/> has it.</param>
    internal double PixelSide(Vector3D lineOfSightMoonMe)
    {
        Vector3D inCamera = MoonFromCamera.Conjugate * lineOfSightMoonMe;
        double area = Model.PixelArea((inCamera.Y / -inCamera.X, inCamera.Z / inCamera.X));
        return _imagePlaneDistance * Math.Sqrt(area * _imagePlaneDistance / lineOfSightMoonMe.Length);
    }

    /// <summary>How a direction in the image plane of a pinhole appears in the image.</summary>
    /// <param name="lineOfSightMoonMe">The line of sight through the point, forward.</param>
    /// <param name="right">Component to the right.</param>
    /// <param name="down">Component down.</param>
    internal (double Right, double Down) DirectionInImage(Vector3D lineOfSightMoonMe, double right, double down)
    {
        if (Model.IsThesis)
        {
            return (right, down);
        }

        Vector3D inCamera = MoonFromCamera.Conjugate * lineOfSightMoonMe;
        return Model.DirectionInImage((inCamera.Y / -inCamera.X, inCamera.Z / inCamera.X), right, down);
    }
}
