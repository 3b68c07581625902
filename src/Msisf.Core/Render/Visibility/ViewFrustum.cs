using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Visibility;

/// <summary>The rays of an image's pixels as a cone with four sides; tells what of a box may be in the image.</summary>
internal sealed class ViewFrustum
{
    private readonly ImageView _view;
    private readonly Vector3D[] _inward;
    private readonly double _margin;

    public ViewFrustum(ImageView view)
    {
        _view = view;

        // Half a pixel would do; projecting rounds directions by some 1e-16 rad.
        _margin = 1.0 + (view.PixelsPerTangent * 1e-14);
        double left = view.CentreX + _margin;
        double right = view.Camera.Width - 1.0 + _margin - view.CentreX;
        double top = view.CentreY + _margin;
        double bottom = view.Camera.Height - 1.0 + _margin - view.CentreY;
        _inward =
        [
            (left * view.Forward) + view.Across,
            (right * view.Forward) - view.Across,
            (top * view.Forward) + view.Down,
            (bottom * view.Forward) - view.Down,
            view.Forward,
        ];
    }

    /// <summary>Rows in which a box may be seen.</summary>
    /// <param name="box">The box.</param>
    /// <param name="rows">From 0; all of the image's for a box that the camera's plane meets.</param>
    /// <returns>False for a box that is certainly outside the image.</returns>
    public bool TryFindRows(in BlockBox box, out (int First, int Last) rows)
    {
        rows = (0, _view.Camera.Height - 1);
        Vector3D centre = (box.Radius * box.Up) - _view.Camera.PositionMoonMe;
        foreach (Vector3D inward in _inward)
        {
            if (Vector3D.Dot(inward, centre) + Reach(inward, box) < 0.0)
            {
                return false;
            }
        }

        if (Vector3D.Dot(_view.Forward, centre) - Reach(_view.Forward, box) <= 0.0)
        {
            return true;
        }

        (double top, double bottom) = RowsOf(centre, box);
        rows = (
            (int)Math.Clamp(Math.Floor(top - _margin), 0.0, _view.Camera.Height),
            (int)Math.Clamp(Math.Ceiling(bottom + _margin), -1.0, _view.Camera.Height - 1.0));
        return rows.First <= rows.Last;
    }

    private static double Reach(Vector3D direction, in BlockBox box) =>
        Math.Abs(Vector3D.Dot(direction, box.HalfUp))
        + Math.Abs(Vector3D.Dot(direction, box.HalfEast))
        + Math.Abs(Vector3D.Dot(direction, box.HalfNorth));

    /// <summary>Of a box in front of the camera: the extremes are at corners.</summary>
    private (double Top, double Bottom) RowsOf(Vector3D centre, in BlockBox box)
    {
        (double Down, double Depth) middle = Project(centre);
        (double Down, double Depth) up = Project(box.HalfUp);
        (double Down, double Depth) east = Project(box.HalfEast);
        (double Down, double Depth) north = Project(box.HalfNorth);
        double top = double.PositiveInfinity;
        double bottom = double.NegativeInfinity;
        for (int corner = 0; corner < 8; corner++)
        {
            double u = (corner & 1) == 0 ? -1.0 : 1.0;
            double e = (corner & 2) == 0 ? -1.0 : 1.0;
            double n = (corner & 4) == 0 ? -1.0 : 1.0;
            double row = (middle.Down + (u * up.Down) + (e * east.Down) + (n * north.Down))
                / (middle.Depth + (u * up.Depth) + (e * east.Depth) + (n * north.Depth));
            top = Math.Min(top, row);
            bottom = Math.Max(bottom, row);
        }

        return (top + _view.CentreY, bottom + _view.CentreY);
    }

    private (double Down, double Depth) Project(Vector3D vector) =>
        (Vector3D.Dot(_view.Down, vector), Vector3D.Dot(_view.Forward, vector));
}
