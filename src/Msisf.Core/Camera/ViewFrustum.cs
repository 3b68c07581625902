namespace Msisf.Core.Camera;

/// <summary>The space that an image, or some of its rows, shows: a four-sided cone from the camera, widened by a margin.</summary>
internal sealed class ViewFrustum
{
    /// <summary>Widens the tangents of a box: more than their rounding.</summary>
    private const double TangentRounding = 1e-12;

    private readonly Vector3D _forward;
    private readonly Vector3D _unitRight;
    private readonly Vector3D _unitUp;
    private readonly Vector3D _down;
    private readonly Vector3D[] _inward;
    private readonly PixelRows _rows;
    private readonly double _forwardRow;
    private readonly double _margin;

    /// <param name="camera">The camera, without a lens.</param>
    /// <param name="margin">px beyond the border of the image on each side.</param>
    /// <param name="rows">The rows that are shown; null for the whole image.</param>
    public ViewFrustum(FrameCamera camera, double margin, PixelRows? rows = null)
        : this(camera, BorderOf(camera, margin, rows ?? new PixelRows(0, camera.Height)))
    {
        _rows = rows ?? new PixelRows(0, camera.Height);
        _margin = margin;
        if (camera.Model.IsThesis)
        {
            _down = -1.0 / camera.PixelTangent * UnitUp(camera);
            _forwardRow = 0.5 * (camera.Height - 1);
        }
        else
        {
            _down = -camera.Model.FocalY * camera.UnitUp;
            _forwardRow = camera.Model.PrincipalY - 1.0;
        }
    }

    private ViewFrustum(FrameCamera camera, (double Left, double Right, double Top, double Bottom) border)
    {
        CameraBodyFixed = camera.PositionBodyFixed;
        _forward = camera.ForwardBodyFixed;
        _rows = new PixelRows(0, camera.Height);
        (double left, double right, double top, double bottom) = border;
        Tangents = new TangentBox(-left, -top, right, -bottom);
        _unitRight = UnitRight(camera);
        _unitUp = UnitUp(camera);
        _inward =
        [
            ((left * _forward) + _unitRight).Normalized(),
            ((right * _forward) - _unitRight).Normalized(),
            (_unitUp - (bottom * _forward)).Normalized(),
            ((top * _forward) - _unitUp).Normalized(),
        ];
    }

    /// <summary>The frustum around the samples of a camera with a lens.</summary>
    /// <param name="tangents">The samples lie in this part of the ideal image plane.</param>
    public static ViewFrustum Of(FrameCamera camera, in TangentBox tangents)
    {
        double margin = camera.PixelTangent;
        return new ViewFrustum(
            camera, (margin - tangents.Left, tangents.Right + margin, margin - tangents.Top, -tangents.Bottom - margin))
        {
            IsOfLens = true,
        };
    }

    /// <summary>Whether the frustum is that of a camera with a lens, so that rows of the image say nothing about it.</summary>
    public bool IsOfLens { get; private init; }

    /// <summary>Where the rays come from, m, body-fixed.</summary>
    public Vector3D CameraBodyFixed { get; }

    /// <summary>The part of the ideal image plane that it shows.</summary>
    public TangentBox Tangents { get; }

    /// <summary>Finds the rows of the image in which a box may be seen.</summary>
    /// <param name="rows">All rows of the frustum for a box that meets the plane through the camera parallel to the image.</param>
    /// <returns>False for a box that is certainly outside.</returns>
    public bool TryFindRows(in OrientedBox box, out PixelRows rows)
    {
        rows = _rows;
        Vector3D centre = box.Centre - CameraBodyFixed;
        foreach (Vector3D inward in _inward)
        {
            if (Vector3D.Dot(inward, centre) + box.ReachAlong(inward) < 0.0)
            {
                return false;
            }
        }

        double depth = Vector3D.Dot(_forward, centre);
        double reach = box.ReachAlong(_forward);
        if (depth - reach <= 0.0)
        {
            return depth + reach >= 0.0;
        }

        (double top, double bottom) = RowsOf(centre, box);
        rows = new PixelRows(
            (int)Math.Clamp(Math.Floor(top - _margin - 0.5), _rows.First, _rows.End),
            (int)Math.Clamp(Math.Ceiling(bottom + _margin + 0.5) + 1.0, _rows.First, _rows.End));
        return rows.First < rows.End;
    }

    /// <summary>The part of the ideal image plane in which a box may be seen; everything for a box that is not wholly in front.</summary>
    public TangentBox TangentsOf(in OrientedBox box)
    {
        Vector3D centre = box.Centre - CameraBodyFixed;
        if (Vector3D.Dot(_forward, centre) - box.ReachAlong(_forward) <= 0.0)
        {
            return TangentBox.Everything;
        }

        TangentBox tangents = TangentBox.Nothing;
        for (int corner = 0; corner < 8; corner++)
        {
            Vector3D at = centre + ((corner & 1) == 0 ? -box.HalfX : box.HalfX) + ((corner & 2) == 0 ? -box.HalfY : box.HalfY)
                + ((corner & 4) == 0 ? -box.HalfZ : box.HalfZ);
            double perDepth = 1.0 / Vector3D.Dot(_forward, at);
            tangents = tangents.With(perDepth * Vector3D.Dot(_unitRight, at), -perDepth * Vector3D.Dot(_unitUp, at));
        }

        double rounding = TangentRounding * (1.0 + tangents.Right - tangents.Left + tangents.Bottom - tangents.Top);
        return new TangentBox(
            tangents.Left - rounding, tangents.Top - rounding, tangents.Right + rounding, tangents.Bottom + rounding);
    }

    /// <summary>Cuts off the part of a polygon that is outside.</summary>
    /// <param name="polygon">Corners, m, body-fixed; convex. Replaced by the corners of the part inside; there can be four more.</param>
    /// <param name="count">Corners before; after: 0 if nothing is inside.</param>
    public void Clip(Span<Vector3D> polygon, ref int count)
    {
        Span<Vector3D> cut = stackalloc Vector3D[polygon.Length];
        foreach (Vector3D inward in _inward)
        {
            int kept = 0;
            for (int corner = 0; corner < count; corner++)
            {
                Vector3D here = polygon[corner];
                Vector3D next = polygon[corner + 1 == count ? 0 : corner + 1];
                double distance = Vector3D.Dot(inward, here - CameraBodyFixed) + Tolerances.VertexLattice;
                double nextDistance = Vector3D.Dot(inward, next - CameraBodyFixed) + Tolerances.VertexLattice;
                if (distance >= 0.0)
                {
                    cut[kept++] = here;
                }

                if ((distance >= 0.0) != (nextDistance >= 0.0))
                {
                    cut[kept++] = here + (distance / (distance - nextDistance) * (next - here));
                }
            }

            cut[..kept].CopyTo(polygon);
            count = kept;
            if (count == 0)
            {
                return;
            }
        }
    }

    /// <summary>Rows, from 0, between which a box in front of the camera is projected: the extremes are at its corners.</summary>
    private (double Top, double Bottom) RowsOf(Vector3D centre, in OrientedBox box)
    {
        (double Down, double Depth) middle = Project(centre);
        (double Down, double Depth) x = Project(box.HalfX);
        (double Down, double Depth) y = Project(box.HalfY);
        (double Down, double Depth) z = Project(box.HalfZ);
        double top = double.PositiveInfinity;
        double bottom = double.NegativeInfinity;
        for (int corner = 0; corner < 8; corner++)
        {
            double i = (corner & 1) == 0 ? -1.0 : 1.0;
            double j = (corner & 2) == 0 ? -1.0 : 1.0;
            double k = (corner & 4) == 0 ? -1.0 : 1.0;
            double row = (middle.Down + (i * x.Down) + (j * y.Down) + (k * z.Down))
                / (middle.Depth + (i * x.Depth) + (j * y.Depth) + (k * z.Depth));
            top = Math.Min(top, row);
            bottom = Math.Max(bottom, row);
        }

        return (top + _forwardRow, bottom + _forwardRow);
    }

    private (double Down, double Depth) Project(Vector3D vector) => (Vector3D.Dot(_down, vector), Vector3D.Dot(_forward, vector));

    private static Vector3D UnitRight(FrameCamera camera) => camera.Model.IsThesis ? camera.Right.Normalized() : camera.UnitRight;

    private static Vector3D UnitUp(FrameCamera camera) => camera.Model.IsThesis ? camera.Up.Normalized() : camera.UnitUp;

    /// <summary>Tangents to the borders of some rows of a pinhole's image: to the left, to the right, and two upwards.</summary>
    private static (double Left, double Right, double Top, double Bottom) BorderOf(
        FrameCamera camera, double margin, PixelRows rows)
    {
        if (camera.Model.IsThesis)
        {
            double pixel = camera.PixelTangent;
            return (
                ((0.5 * camera.Width) + margin) * pixel,
                ((0.5 * camera.Width) + margin) * pixel,
                ((0.5 * camera.Height) + margin - rows.First) * pixel,
                ((0.5 * camera.Height) - margin - rows.End) * pixel);
        }

        (double left, double right) = (0.5 - margin, camera.Width + 0.5 + margin);
        (double top, double bottom) = (rows.First + 0.5 - margin, rows.End + 0.5 + margin);
        TangentBox box = TangentBox.Nothing;
        foreach ((double x, double y) in (ReadOnlySpan<(double, double)>)[(left, top), (right, top), (left, bottom), (right, bottom)])
        {
            (double ofRight, double ofDown) = camera.Model.ToIdeal(x, y);
            box = box.With(ofRight, ofDown);
        }

        return (-box.Left, box.Right, -box.Top, -box.Bottom);
    }
}
