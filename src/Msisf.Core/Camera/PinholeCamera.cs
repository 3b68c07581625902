using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera.Lenses;

namespace Msisf.Core.Camera;

/// <summary>A frame camera without a lens: that of thesis section 8.2, or one with a principal point and skew of its own.</summary>
public sealed class PinholeCamera : FrameCamera
{
    /// <summary>Places the camera of the thesis.</summary>
    /// <param name="positionBodyFixed">Focal point, m, body-fixed.</param>
    /// <param name="fieldOfView">Horizontal field of view, rad, from <see cref="Tolerances.MinFieldOfView"/> to below pi.</param>
    /// <param name="width">Image width, px, at least 1.</param>
    /// <param name="height">Image height, px, at least 1.</param>
    /// <exception cref="BadInputException">The field of view is out of range, or the position's length is not finite.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A size is below 1.</exception>
    /// <exception cref="ArgumentException">The orientation is <c>default</c>, which is not a rotation.</exception>
    public PinholeCamera(Vector3D positionBodyFixed, UnitQuaternion moonFromCamera, double fieldOfView, int width, int height)
        : this(new CameraState(positionBodyFixed, moonFromCamera), CameraModel.FromFieldOfView(fieldOfView, width, height))
    {
    }

    internal PinholeCamera(CameraState state, CameraModel model)
        : base(state, model.Lens is null ? model : throw new ArgumentException("A pinhole has no lens.", nameof(model)))
    {
    }

    /// <inheritdoc/>
    internal override (Vector3D Middle, Vector3D Right, Vector3D Vertical) RayAxes => (Direction, Right, Up);

    /// <inheritdoc/>
    /// <remarks>Thesis eq. 8.15.</remarks>
    public override Ray RayThrough(double x, double y)
    {
        double up = (1.0 + Height - (2.0 * y)) / (2.0 * Height);
        double right = ((2.0 * x) - 1.0 - Width) / (2.0 * Width);
        return new Ray(PositionBodyFixed, Direction + (up * Up) + (right * Right));
    }

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first rows would otherwise be computed with unoptimised vectors
    internal override LaneVector DirectionsThrough(Vector512<double> x, double y)
    {
        double up = (1.0 + Height - (2.0 * y)) / (2.0 * Height);
        Vector512<double> right = ((Vector512.Create(2.0) * x) - Vector512<double>.One - Vector512.Create((double)Width))
            / Vector512.Create(2.0 * Width);
        return LaneVector.All(Direction + (up * Up)) + (right * LaneVector.All(Right));
    }
}

/// <summary>A frame camera with a lens.</summary>
internal sealed class LensCamera(CameraState state, CameraModel model) : FrameCamera(state, model)
{
    internal override (Vector3D Middle, Vector3D Right, Vector3D Vertical) RayAxes =>
        (OpticalAxis, ImagePlaneDistance * UnitRight, -ImagePlaneDistance * UnitUp);

    public override Ray RayThrough(double x, double y)
    {
        (double right, double down) = Model.ToIdeal(x, y);
        (Vector3D middle, Vector3D toRight, Vector3D toDown) = RayAxes;
        return new Ray(PositionBodyFixed, middle + (right * toRight) + (down * toDown));
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first rows would otherwise be computed with unoptimised vectors
    internal override LaneVector DirectionsThrough(Vector512<double> x, double y)
    {
        (Vector3D middle, Vector3D toRight, Vector3D toDown) = RayAxes;
        LanePoints ideal = Model.ToIdeal(x, Vector512.Create(y));
        LaneVector alongRow = LaneVector.All(middle) + (ideal.X * LaneVector.All(toRight));
        return alongRow + (ideal.Y * LaneVector.All(toDown));
    }
}
