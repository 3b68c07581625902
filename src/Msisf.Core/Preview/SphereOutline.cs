using Msisf.Core.Camera;

namespace Msisf.Core.Preview;

/// <summary>Where an image shows a sphere: the rows, and of each row an interval. Coordinates are those of the image plane.</summary>
internal sealed class SphereOutline
{
    /// <summary>
    /// Steps from the lowest to the highest row, among which one is looked for that shows the sphere; both ends are, for the image's
    /// corners.
    /// </summary>
    private const int Trials = 64;

    /// <summary>Halvings of a distance between rows, to find where the sphere ends: a billionth of it is left.</summary>
    private const int Halvings = 30;

    private readonly Vector3D _toCentre;
    private readonly double _sinLimb;
    private readonly double _cosLimb;
    private readonly TangentBox _image;

    /// <param name="toCentre">Direction of the sphere's centre: components forward, right and up; length 1.</param>
    /// <param name="radius">Radius of the sphere, m.</param>
    /// <param name="distance">Distance of its centre, m; at least the radius.</param>
    public SphereOutline(Vector3D toCentre, double radius, double distance, TangentBox image)
    {
        _toCentre = toCentre;
        _sinLimb = radius / distance;
        _cosLimb = Math.Sqrt(distance - radius) * Math.Sqrt(distance + radius) / distance; // the product of far distances overflows
        _image = image;
    }

    /// <summary>Area of the image, in image plane coordinates.</summary>
    public double ImageArea => _image.Area;

    /// <summary>A number between two, at a place from -1 to 1.</summary>
    public static double At(double first, double last, double place) => (0.5 * (first + last)) + (0.5 * (last - first) * place);

    /// <summary>Finds the rows that show the sphere; what is seen of it is convex, so that they follow one another.</summary>
    public bool TryFindRows(out double bottom, out double top)
    {
        bottom = -_image.Bottom;
        top = -_image.Top;
        double inColumnPlane = double.Hypot(_toCentre.X, _toCentre.Z);
        if (inColumnPlane > _sinLimb)
        {
            double middle = Math.Atan2(_toCentre.Z, _toCentre.X);
            double reach = Math.Atan2(_sinLimb, Math.Sqrt((inColumnPlane - _sinLimb) * (inColumnPlane + _sinLimb)));
            (bottom, top) = (Within(middle - reach, bottom, top, 1.0), Within(middle + reach, bottom, top, 1.0));
        }

        for (int trial = 0; trial <= Trials; trial++)
        {
            double shown = At(bottom, top, (2.0 * trial / Trials) - 1.0);
            if (Shows(shown))
            {
                bottom = LastThatShows(shown, bottom);
                top = LastThatShows(shown, top);
                return bottom < top;
            }
        }

        return false;
    }

    private double LastThatShows(double shown, double end)
    {
        if (Shows(end))
        {
            return end;
        }

        for (int i = 0; i < Halvings; i++)
        {
            double middle = 0.5 * (shown + end);
            if (Shows(middle))
            {
                shown = middle;
            }
            else
            {
                end = middle;
            }
        }

        return shown;
    }

    private bool Shows(double b)
    {
        (double from, double to) = Interval(b);
        return from < to;
    }

    /// <summary>
    /// The interval of a row that shows the sphere, by the angles in the plane through the camera and the row; without length if none does.
    /// </summary>
    public (double From, double To) Interval(double b)
    {
        double cosRow = 1.0 / Math.Sqrt(1.0 + (b * b));
        double along = cosRow * (_toCentre.X + (b * _toCentre.Z));
        double beside = cosRow * (_toCentre.Z - (b * _toCentre.X));
        double middle = Math.Atan2(_toCentre.Y, along);
        double reach = Math.Atan2(Math.Sqrt(Math.Max(0.0, (_sinLimb - beside) * (_sinLimb + beside))), _cosLimb);
        return (
            Within(middle - reach, _image.Left, _image.Right, cosRow), Within(middle + reach, _image.Left, _image.Right, cosRow));
    }

    /// <summary>
    /// Where a direction meets a row or column of the image, at most its end: the very number, so that a sphere beside the image has no
    /// length in it.
    /// </summary>
    /// <param name="angle">rad, in the plane through the camera and the row or column.</param>
    /// <param name="first">Where the image begins.</param>
    /// <param name="last">Where it ends.</param>
    /// <param name="cos">Cosine of the angle between the viewing direction and that plane.</param>
    private static double Within(double angle, double first, double last, double cos) =>
        angle <= Math.Atan(first * cos) ? first
        : angle >= Math.Atan(last * cos) ? last
        : Math.Clamp(Math.Tan(angle) / cos, first, last);
}
