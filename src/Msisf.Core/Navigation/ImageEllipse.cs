using Msisf.Core.Camera;

namespace Msisf.Core.Navigation;

/// <summary>An ellipse in an image, in rendering coordinates: px, whole numbers are pixel centres from 1.</summary>
/// <param name="X">Centre, to the right.</param>
/// <param name="Y">Centre, down.</param>
/// <param name="SemiMajor">px.</param>
/// <param name="SemiMinor">px.</param>
/// <param name="Angle">rad from x towards y, (-pi/2, pi/2]: of the major axis; 0 of a circle.</param>
public readonly record struct ImageEllipse(double X, double Y, double SemiMajor, double SemiMinor, double Angle)
{
    /// <summary>Newton's steps that any point needs at most: each one at least halves the distance to the root.</summary>
    private const int MostNewtonSteps = 100;

    /// <summary>1: relative change of the root at which it is found.</summary>
    private const double NewtonPrecision = 1e-15;

    /// <summary>px^2.</summary>
    public double Area => Math.PI * SemiMajor * SemiMinor;

    /// <summary>px: how far it reaches to the right and down of its centre.</summary>
    public (double Right, double Down) Reach
    {
        get
        {
            (double sin, double cos) = Trigonometry.SinCos(Angle);
            return (double.Hypot(SemiMajor * cos, SemiMinor * sin), double.Hypot(SemiMajor * sin, SemiMinor * cos));
        }
    }

    /// <summary>The ellipse whose points x have (x - centre)^T shape^-1 (x - centre) = 1.</summary>
    /// <param name="columns">
    /// Vectors the sum of whose squares (v v^T) is the shape; its determinant is then a sum of squares too and keeps its digits where the
    /// ellipse is narrow.
    /// </param>
    public static ImageEllipse OfShape(double x, double y, ReadOnlySpan<(double X, double Y)> columns)
    {
        (double xx, double xy, double yy, double determinant) = (0.0, 0.0, 0.0, 0.0);
        for (int i = 0; i < columns.Length; i++)
        {
            (double vx, double vy) = columns[i];
            (xx, xy, yy) = (xx + (vx * vx), xy + (vx * vy), yy + (vy * vy));
            for (int j = 0; j < i; j++)
            {
                double area = Stable.DifferenceOfProducts(vx, columns[j].Y, vy, columns[j].X);
                determinant += area * area;
            }
        }

        double major = (0.5 * (xx + yy)) + double.Hypot(0.5 * (xx - yy), xy);
        double angle = 0.5 * Trigonometry.Atan2(2.0 * xy, xx - yy);
        return new ImageEllipse(
            x, y, Math.Sqrt(major), Math.Sqrt(determinant / major), angle <= -0.5 * Math.PI ? 0.5 * Math.PI : angle);
    }

    /// <summary>A point of the ellipse.</summary>
    /// <param name="anomaly">rad from the major axis; not the angle at the centre.</param>
    public RenderingPoint PointAt(double anomaly)
    {
        (double sinOf, double cosOf) = Trigonometry.SinCos(anomaly);
        return PointAt(sinOf, cosOf);
    }

    /// <summary>A point of the ellipse by the sine and cosine of its anomaly.</summary>
    internal RenderingPoint PointAt(double sinOf, double cosOf)
    {
        (double sin, double cos) = Trigonometry.SinCos(Angle);
        (double along, double across) = (SemiMajor * cosOf, SemiMinor * sinOf);
        return new RenderingPoint(X + (cos * along) - (sin * across), Y + (sin * along) + (cos * across));
    }

    /// <summary>A point in the coordinates in which the ellipse is the circle of radius 1 around (0, 0).</summary>
    public (double X, double Y) ToUnitCircle(double x, double y)
    {
        (double sin, double cos) = Trigonometry.SinCos(Angle);
        return ToUnitCircle(x, y, sin, cos);
    }

    /// <summary>px: distance of a point from the ellipse.</summary>
    public double DistanceTo(double x, double y)
    {
        (double sinOf, double cosOf) = AnomalyNearest(x, y);
        RenderingPoint nearest = PointAt(sinOf, cosOf);
        return double.Hypot(x - nearest.X, y - nearest.Y);
    }

    /// <summary>Sine and cosine of the anomaly of the ellipse's point that is nearest to a point.</summary>
    /// <remarks>
    /// D. Eberly, "Distance from a point to an ellipse, an ellipsoid, or a hyperellipsoid" (2013): with the point (u, v) in the quarter of
    /// positive axes a, b, the nearest one is (a^2 u / (t + a^2), b^2 v / (t + b^2)), where t is the largest root of
    /// (a u / (t + a^2))^2 + (b v / (t + b^2))^2 = 1. The left side falls and is convex there, so that Newton's steps from below end at it.
    /// </remarks>
    internal (double Sin, double Cos) AnomalyNearest(double x, double y)
    {
        (double sin, double cos) = Trigonometry.SinCos(Angle);
        (double right, double down) = (x - X, y - Y);
        (double along, double across) = ((cos * right) + (sin * down), (cos * down) - (sin * right));

        // In units of the minor axis, with t + 1 as the unknown.
        double ratio = SemiMajor / SemiMinor;
        (double u, double v) = (Math.Abs(along) / SemiMinor, Math.Abs(across) / SemiMinor);
        double more = (ratio - 1.0) * (ratio + 1.0);
        if (!(v > 0.0 || ratio * u > more))
        {
            // On the major axis between the centres of curvature of its ends: the nearest points lie on both sides.
            double cosOf = more > 0.0 ? ratio * u / more : 1.0;
            return (Math.Sqrt((1.0 - cosOf) * (1.0 + cosOf)), along < 0.0 ? -cosOf : cosOf);
        }

        double root = Math.Max(v, (ratio * u) - more);
        for (int step = 0; step < MostNewtonSteps; step++)
        {
            double first = ratio * u / (root + more);
            double second = v / root;
            double slope = 2.0 * ((first * first / (root + more)) + (second * second / root));
            double change = ((first * first) + (second * second) - 1.0) / slope;
            root += change;
            if (!(change > root * NewtonPrecision))
            {
                break;
            }
        }

        (double cosine, double sine) = (ratio * u / (root + more), v / root);
        double length = double.Hypot(cosine, sine);
        return (across < 0.0 ? -sine / length : sine / length, along < 0.0 ? -cosine / length : cosine / length);
    }

    /// <summary>The columns of a row whose pixels' centres lie in the ellipse and in the image.</summary>
    /// <param name="row">Rendering coordinate, whole.</param>
    /// <param name="width">Width of the image, px.</param>
    /// <returns>Rendering coordinates; none if the first is beyond the last.</returns>
    public (int First, int Last) ColumnsOf(int row, int width)
    {
        // On the row the ellipse's form is a x^2 + 2 b x + c = 1 with x from the centre.
        (double sin, double cos) = Trigonometry.SinCos(Angle);
        double down = row - Y;
        (double ax, double bx) = (cos / SemiMajor, -sin / SemiMinor);
        (double ay, double by) = (sin / SemiMajor * down, cos / SemiMinor * down);
        double square = (ax * ax) + (bx * bx);
        double middle = -((ax * ay) + (bx * by)) / square;
        double cross = Stable.DifferenceOfProducts(ax, by, bx, ay);
        double rest = square - (cross * cross);
        if (rest < 0.0)
        {
            return (1, 0);
        }

        double half = Math.Sqrt(rest) / square;
        return (
            (int)Math.Max(1.0, Math.Ceiling(X + middle - half)), (int)Math.Min(width, Math.Floor(X + middle + half)));
    }

    /// <summary>px^2: area of the part of the ellipse inside an image.</summary>
    public double AreaInside(int width, int height)
    {
        (double sin, double cos) = Trigonometry.SinCos(Angle);
        ReadOnlySpan<(double X, double Y)> corners =
        [
            ToUnitCircle(0.5, 0.5, sin, cos), ToUnitCircle(width + 0.5, 0.5, sin, cos),
            ToUnitCircle(width + 0.5, height + 0.5, sin, cos), ToUnitCircle(0.5, height + 0.5, sin, cos),
        ];
        double area = 0.0;
        for (int i = 0; i < corners.Length; i++)
        {
            area += SectorArea(corners[i], corners[(i + 1) % corners.Length]);
        }

        return Math.Clamp(area, 0.0, Math.PI) * SemiMajor * SemiMinor;
    }

    /// <summary>Area, with its sign, of the triangle of (0, 0) and two points inside the unit circle.</summary>
    private static double SectorArea((double X, double Y) from, (double X, double Y) to)
    {
        (double dx, double dy) = (to.X - from.X, to.Y - from.Y);
        double square = (dx * dx) + (dy * dy);
        double foot = -((from.X * dx) + (from.Y * dy)) / square;
        double cross = Stable.DifferenceOfProducts(from.X, to.Y, from.Y, to.X);
        double rest = 1.0 - (cross * cross / square);
        if (!(rest > 0.0))
        {
            return Wedge(from, to);
        }

        double half = Math.Sqrt(rest / square);
        double enter = Math.Clamp(foot - half, 0.0, 1.0);
        double leave = Math.Clamp(foot + half, 0.0, 1.0);
        (double X, double Y) first = (from.X + (enter * dx), from.Y + (enter * dy));
        (double X, double Y) last = (from.X + (leave * dx), from.Y + (leave * dy));
        double inside = 0.5 * cross * (leave - enter);
        return (enter > 0.0 ? Wedge(from, first) : 0.0) + inside + (leave < 1.0 ? Wedge(last, to) : 0.0);
    }

    private static double Wedge((double X, double Y) from, (double X, double Y) to) => 0.5 * Trigonometry.Atan2(
        Stable.DifferenceOfProducts(from.X, to.Y, from.Y, to.X), (from.X * to.X) + (from.Y * to.Y));

    private (double X, double Y) ToUnitCircle(double x, double y, double sin, double cos)
    {
        (double right, double down) = (x - X, y - Y);
        return (((cos * right) + (sin * down)) / SemiMajor, ((cos * down) - (sin * right)) / SemiMinor);
    }
}
