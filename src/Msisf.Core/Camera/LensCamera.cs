using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera.Lenses;

namespace Msisf.Core.Camera;

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

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first rows would else be computed with unoptimised vectors
    internal override void FindDirections(int row, ReadOnlySpan<int> columns, VectorRow directions)
    {
        (Vector3D middle, Vector3D toRight, Vector3D toDown) = RayAxes;
        Span<double> xs = stackalloc double[Vector512<double>.Count];
        for (int i = 0; i < columns.Length; i += Vector512<double>.Count)
        {
            LanePoints ideal = Model.ToIdeal(CentresOf(columns, i, xs), Vector512.Create(row + 1.0));
            LaneVector alongRow = LaneVector.All(middle) + (ideal.X * LaneVector.All(toRight));
            (alongRow + (ideal.Y * LaneVector.All(toDown))).Store(directions, i);
        }
    }
}
