using Msisf.Core.Numerics;

namespace Msisf.Core.Camera;

/// <summary>The space that an image, or some of its rows, shows: a four-sided cone from the camera, widened by a margin.</summary>
internal sealed class ViewFrustum
{
    private readonly Vector3D _forward;
    private readonly Vector3D _down;
    private readonly Vector3D[] _inward;
    private readonly Vector3D[] _edges;
    private readonly PixelRows _rows;
    private readonly double _forwardRow;
    private readonly double _margin;

    /// <param name="camera">The camera.</param>
    /// <param name="margin">px beyond the border of the image on each side.</param>
    /// <param name="rows">The rows that are shown; null for the whole image.</param>
    /// <param name="offsetX">px to the right, added to each pixel's centre.</param>
    /// <param name="offsetY">px down, added to each pixel's centre.</param>
    public ViewFrustum(PinholeCamera camera, double margin, PixelRows? rows = null, double offsetX = 0.0, double offsetY = 0.0)
    {
        CameraMoonMe = camera.PositionMoonMe;
        _forward = camera.ForwardMoonMe;
        _rows = rows ?? new PixelRows(0, camera.Height);
        _margin = margin;
        double pixel = camera.PixelTangent;
        double left = ((0.5 * camera.Width) - offsetX + margin) * pixel;
        double right = ((0.5 * camera.Width) + offsetX + margin) * pixel;
        double top = ((0.5 * camera.Height) - offsetY + margin - _rows.First) * pixel;
        double bottom = ((0.5 * camera.Height) - offsetY - margin - _rows.End) * pixel;
        Vector3D unitRight = camera.Right.Normalized();
        Vector3D unitUp = camera.Up.Normalized();
        _down = -1.0 / pixel * unitUp;
        _forwardRow = (0.5 * (camera.Height - 1)) - offsetY;
        _inward =
        [
            ((left * _forward) + unitRight).Normalized(),
            ((right * _forward) - unitRight).Normalized(),
            (unitUp - (bottom * _forward)).Normalized(),
            ((top * _forward) - unitUp).Normalized(),
        ];
        _edges =
        [
            _forward + (right * unitRight) + (top * unitUp),
            _forward + (right * unitRight) + (bottom * unitUp),
            _forward - (left * unitRight) + (top * unitUp),
            _forward - (left * unitRight) + (bottom * unitUp),
        ];
        Middle = (_forward + (0.5 * (right - left) * unitRight) + (0.5 * (top + bottom) * unitUp)).Normalized();
    }

    /// <summary>Where the rays come from, m, MOON_ME.</summary>
    public Vector3D CameraMoonMe { get; }

    /// <summary>Direction of the middle of the rows, MOON_ME, length 1.</summary>
    public Vector3D Middle { get; }

    /// <summary>Directions of the four edges, MOON_ME.</summary>
    public ReadOnlySpan<Vector3D> Edges => _edges;

    /// <summary>Whether a direction from the camera, MOON_ME, lies inside.</summary>
    public bool Contains(Vector3D direction)
    {
        foreach (Vector3D inward in _inward)
        {
            if (Vector3D.Dot(inward, direction) < 0.0)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Where a ball lies.</summary>
    /// <param name="ball">Centre (m, MOON_ME) and radius (m).</param>
    public FrustumSide Classify((Vector3D Centre, double Radius) ball)
    {
        Vector3D fromCamera = ball.Centre - CameraMoonMe;
        FrustumSide side = FrustumSide.Inside;
        foreach (Vector3D inward in _inward)
        {
            double distance = Vector3D.Dot(inward, fromCamera);
            if (distance < -ball.Radius)
            {
                return FrustumSide.Outside;
            }

            if (distance < ball.Radius)
            {
                side = FrustumSide.Straddling;
            }
        }

        return side;
    }

    /// <summary>Finds the rows of the image in which a box may be seen.</summary>
    /// <param name="box">The box.</param>
    /// <param name="rows">All rows of the frustum for a box that meets the plane through the camera parallel to the image.</param>
    /// <returns>False for a box that is certainly outside.</returns>
    public bool TryFindRows(in OrientedBox box, out PixelRows rows)
    {
        rows = _rows;
        Vector3D centre = box.Centre - CameraMoonMe;
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

    /// <summary>Cuts off the part of a polygon that is outside.</summary>
    /// <param name="polygon">Corners, m, MOON_ME; convex. Replaced by the corners of the part inside; there can be four more.</param>
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
                double distance = Vector3D.Dot(inward, here - CameraMoonMe) + Tolerances.VertexLattice;
                double nextDistance = Vector3D.Dot(inward, next - CameraMoonMe) + Tolerances.VertexLattice;
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
}
