using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Camera;

/// <summary>
/// A camera that sees its whole image at one instant. Camera axes: it looks along -x, y is to the right, z is up; the quaternion turns
/// camera axes into Moon axes (thesis chapter 7; docs/deviations.md, row 7). Its rays are those of POV-Ray's perspective camera (section
/// 8.2), or, with a lens, of one with other rays of the same distance to the image plane.
/// </summary>
public abstract class FrameCamera : ICamera
{
    private readonly CameraBand[] _bands;

    private protected FrameCamera(CameraState state, CameraModel model)
    {
        if (!double.IsFinite(state.PositionBodyFixed.Length))
        {
            throw new BadInputException(
                $"The camera position {state.PositionBodyFixed} m is not finite, or farther away than numbers reach.");
        }

        if (state.MoonFromCamera == default)
        {
            throw new ArgumentException("The default quaternion is not a rotation.", nameof(state));
        }

        (State, Model) = (state, model);
        _bands = [new CameraBand(new PixelRows(0, Height), this)];
        ForwardBodyFixed = MoonFromCamera * -Vector3D.UnitX;
        UnitRight = MoonFromCamera * Vector3D.UnitY;
        UnitUp = MoonFromCamera * Vector3D.UnitZ;
        if (model.IsThesis)
        {
            double aspect = (double)Width / Height;
            Right = aspect * UnitRight;
            Up = UnitUp;
            ImagePlaneDistance = aspect / 2.0 / Math.Tan(FieldOfView / 2.0);
            Direction = ImagePlaneDistance * ForwardBodyFixed;

            double right = Math.Tan(FieldOfView / 2.0);
            PixelTangent = 2.0 * right / Width;
            double up = 0.5 * Height * PixelTangent;
            Footprint = new PixelFootprint(
                PositionBodyFixed, ForwardBodyFixed, PixelTangent, 1.0 / Math.Sqrt(1.0 + (right * right) + (up * up)));
            return;
        }

        // The axes of POV-Ray for a pinhole of any kind: up again has the length of the image's height, but for the skew.
        ImagePlaneDistance = model.FocalY / Height;
        double shear = model.Skew / model.FocalX;
        double middleDown = ((0.5 * (1.0 + Height)) - model.PrincipalY) / model.FocalY;
        double middleRight = (((0.5 * (1.0 + Width)) - model.PrincipalX) / model.FocalX) - (shear * middleDown);
        Right = ImagePlaneDistance * Width / model.FocalX * UnitRight;
        Up = UnitUp + (shear * UnitRight);
        Direction = ImagePlaneDistance * (ForwardBodyFixed + (middleRight * UnitRight) - (middleDown * UnitUp));
        PixelTangent = model.MinPixelTangent();
        double border = model.BorderTangent();
        Footprint = new PixelFootprint(PositionBodyFixed, ForwardBodyFixed, PixelTangent, 1.0 / Math.Sqrt(1.0 + (border * border)));
    }

    /// <summary>Time, position, orientation and Sun of all rows.</summary>
    public CameraState State { get; }

    /// <summary>Size, focal length, principal point and distortion.</summary>
    public CameraModel Model { get; }

    /// <inheritdoc/>
    public IReadOnlyList<CameraBand> Bands => _bands;

    /// <inheritdoc/>
    public Vector3D PositionBodyFixed => State.PositionBodyFixed;

    /// <inheritdoc/>
    public UnitQuaternion MoonFromCamera => State.MoonFromCamera;

    /// <summary>Horizontal field of view, rad.</summary>
    public double FieldOfView => Model.FieldOfView;

    /// <inheritdoc/>
    public int Width => Model.Width;

    /// <inheritdoc/>
    public int Height => Model.Height;

    /// <summary>Viewing direction of length 1, body-fixed.</summary>
    public Vector3D ForwardBodyFixed { get; }

    /// <summary>To the right in the image along its rows, body-fixed, length 1, perpendicular to the viewing direction.</summary>
    public Vector3D UnitRight { get; }

    /// <summary>Up, body-fixed, length 1, perpendicular to the viewing direction and to the right.</summary>
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
    public double ImagePlaneDistance { get; }

    /// <summary>
    /// Direction of the ray along the optical axis, MOON_ME: the part along the axis of each ray's direction. <see cref="Direction"/> leads
    /// elsewhere where the principal point is not in the middle, and is longer.
    /// </summary>
    internal Vector3D OpticalAxis => ImagePlaneDistance * ForwardBodyFixed;

    /// <summary>Tangent of the angle of a pixel in the middle of the image, or of the smallest pixel if they differ.</summary>
    public double PixelTangent { get; }

    /// <summary>The width that the pixels cover at a distance.</summary>
    public PixelFootprint Footprint { get; }

    /// <summary>
    /// What the directions of rays are made of: the middle, and the vectors that a ray's two factors multiply. A pinhole's are parts of
    /// the image's width and height, the same along a row the second; a lens's are tangents, right and down.
    /// </summary>
    internal abstract (Vector3D Middle, Vector3D Right, Vector3D Vertical) RayAxes { get; }

    /// <inheritdoc/>
    public abstract Ray RayThrough(double x, double y);

    /// <summary>The directions of the rays through eight points of the image, each with the bits of <see cref="RayThrough"/>.</summary>
    /// <param name="x">Rendering coordinates.</param>
    /// <param name="y">Rendering coordinate of all of them.</param>
    internal abstract LaneVector DirectionsThrough(Vector512<double> x, double y);

    /// <summary>The directions of the rays through the centres of pixels, with the bits of <see cref="RayThrough"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first rows would otherwise be computed with unoptimised vectors
    internal void FindDirections(int row, ReadOnlySpan<int> columns, VectorRow directions)
    {
        Span<double> xs = stackalloc double[Vector512<double>.Count];
        for (int i = 0; i < columns.Length; i += xs.Length)
        {
            for (int lane = 0; lane < xs.Length; lane++)
            {
                xs[lane] = columns[Math.Min(i + lane, columns.Length - 1)] + 1;
            }

            DirectionsThrough(Vector512.Create<double>(xs), row + 1.0).Store(directions, i);
        }
    }

    /// <summary>Where the line from the focal point along a direction meets the image plane.</summary>
    /// <param name="directionBodyFixed">From the focal point, body-fixed, any length.</param>
    /// <param name="point">Rendering coordinates; (0, 0) if there are none.</param>
    /// <returns>False for a direction that does not lead forward through the image plane.</returns>
    /// <remarks>
    /// Decomposed on right and up: the products of thesis eq. 9.20 cancel, which cost the published angles 5e-5 degrees
    /// (docs/deviations.md, row 10).
    /// </remarks>
    public bool TryProject(Vector3D directionBodyFixed, out RenderingPoint point)
    {
        Vector3D inCamera = MoonFromCamera.Conjugate * directionBodyFixed;
        if (!Model.IsThesis)
        {
            point = default;
            return -inCamera.X > 0.0 && Model.TryToImage(inCamera.Y / -inCamera.X, inCamera.Z / inCamera.X, out point);
        }

        // One unit of the image plane is Height px in both directions: Right spans aspect units and Width px.
        double scale = Height * ImagePlaneDistance / -inCamera.X;
        double x = ((1.0 + Width) / 2.0) + (scale * inCamera.Y);
        double y = ((1.0 + Height) / 2.0) - (scale * inCamera.Z);
        bool isInFront = scale > 0.0 && double.IsFinite(x) && double.IsFinite(y);
        point = isInFront ? new RenderingPoint(x, y) : default;
        return isInFront;
    }

    /// <inheritdoc/>
    public bool TryProjectPoint(Vector3D pointBodyFixed, out RenderingPoint point) =>
        TryProject(pointBodyFixed - PositionBodyFixed, out point);

    /// <inheritdoc/>
    public CameraBand BandAt(double y) => _bands[0];

    /// <inheritdoc/>
    public ICamera Window(int left, int top, int width, int height)
    {
        CameraModel model = Model.Window(left, top, width, height);
        return ReferenceEquals(model, Model) ? this : model.At(State);
    }

    /// <inheritdoc/>
    public ICamera Moved(CameraMotion motion, double seconds) =>
        seconds == 0.0 || motion.IsRest ? this : Model.At(motion.Moved(State, seconds));

    /// <summary>
    /// m: side of the square that has the area of the pixel's beam across the line of sight. A pixel is a square of side 1 / height
    /// in the image plane at distance f; seen from the focal point, at an angle a off the axis, it covers (1 / (height f))^2 cos^3 a
    /// steradians, to first order in its size; and cos a is depth over range.
    /// </summary>
    /// <param name="ray">The pixel's ray, as <see cref="RayThrough"/> has it.</param>
    /// <param name="rayParameter">Where on the ray: origin + parameter times direction.</param>
    public double PixelSide(Ray ray, double rayParameter) =>
        PixelSide(OpticalAxis.Length, ray.Direction, ray.Direction.Length, rayParameter);

    /// <summary>The same, for a caller that knows the length of the ray's direction and its component along the optical axis.</summary>
    internal double PixelSide(double axisLength, Vector3D direction, double directionLength, double rayParameter)
    {
        if (Model.IsThesis)
        {
            return rayParameter * Math.Sqrt(axisLength / directionLength) / Height;
        }

        double area = Model.PixelArea(TangentsOf(direction));
        return rayParameter * (ImagePlaneDistance * Math.Sqrt(area * ImagePlaneDistance / direction.Length));
    }

    /// <summary>sr: solid angle of a pixel in a direction, to first order in its size.</summary>
    /// <param name="directionBodyFixed">Forward, length 1.</param>
    public double SolidAngle(Vector3D directionBodyFixed)
    {
        double cosine = Vector3D.Dot(ForwardBodyFixed, directionBodyFixed);
        return Model.PixelArea(TangentsOf(directionBodyFixed)) * cosine * cosine * cosine;
    }

    /// <summary>How a direction in the image plane of a pinhole appears in the image.</summary>
    /// <param name="lineOfSightBodyFixed">The line of sight through the point, forward.</param>
    internal (double Right, double Down) DirectionInImage(Vector3D lineOfSightBodyFixed, double right, double down) =>
        Model.IsThesis ? (right, down) : Model.DirectionInImage(TangentsOf(lineOfSightBodyFixed), right, down);

    private (double Right, double Down) TangentsOf(Vector3D directionBodyFixed)
    {
        Vector3D inCamera = MoonFromCamera.Conjugate * directionBodyFixed;
        return (inCamera.Y / -inCamera.X, inCamera.Z / inCamera.X);
    }
}
