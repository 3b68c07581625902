using Msisf.Core.Camera;

namespace Msisf.Core.Navigation;

/// <summary>The part of an ellipse that lies inside an image, as a polygon.</summary>
public static class EllipsePolygon
{
    /// <summary>px: how far a side may lie from the ellipse.</summary>
    private const double Deviation = 0.02;

    /// <summary>Sides of an arc at least, so that the area of a small part is right to 0.4 %.</summary>
    private const int FewestSides = 16;

    /// <summary>1: corners that are nearer than this, relative to the image's size, are one.</summary>
    private const double SamePoint = 1e-12;

    /// <summary>
    /// The corners in order. Where the ellipse reaches farthest, where it crosses a border of the image, and the image's corners in the
    /// ellipse are among them, so that the polygon's box is that of the part.
    /// </summary>
    /// <param name="width">Width of the image, px.</param>
    /// <param name="height">px.</param>
    /// <returns>Empty if no part lies inside.</returns>
    public static IReadOnlyList<RenderingPoint> Of(ImageEllipse ellipse, int width, int height)
    {
        (double right, double bottom) = (width + 0.5, height + 0.5);
        List<RenderingPoint> corners =
        [
            .. ((ReadOnlySpan<RenderingPoint>)[new(0.5, 0.5), new(right, 0.5), new(right, bottom), new(0.5, bottom)]).ToArray()
                .Where(corner => ellipse.ToUnitCircle(corner.X, corner.Y) is var (x, y) && (x * x) + (y * y) < 1.0),
        ];

        // A point is at X + across cos(anomaly) - along sin(anomaly), a border of which is met twice or not.
        (double sin, double cos) = Trigonometry.SinCos(ellipse.Angle);
        (double X, double Y) ofCosine = (ellipse.SemiMajor * cos, ellipse.SemiMajor * sin);
        (double X, double Y) ofSine = (-ellipse.SemiMinor * sin, ellipse.SemiMinor * cos);
        List<double> ends = [];
        AddEnds(ends, ofCosine.X, ofSine.X, [0.5 - ellipse.X, right - ellipse.X]);
        AddEnds(ends, ofCosine.Y, ofSine.Y, [0.5 - ellipse.Y, bottom - ellipse.Y]);
        ends.Sort();
        double step = 4.0 * Math.Atan(Math.Sqrt(Deviation / (2.0 * Math.Max(ellipse.SemiMajor, Deviation))));
        for (int i = 0; i < ends.Count; i++)
        {
            double from = ends[i];
            double length = (i + 1 < ends.Count ? ends[i + 1] : ends[0] + (2.0 * Math.PI)) - from;
            RenderingPoint middle = ellipse.PointAt(from + (0.5 * length));
            if (middle.X >= 0.5 && middle.X <= right && middle.Y >= 0.5 && middle.Y <= bottom)
            {
                int sides = Math.Max(FewestSides, (int)Math.Ceiling(length / step));
                corners.AddRange(Enumerable.Range(0, sides + 1).Select(side => Within(ellipse.PointAt(from + (length * side / sides)))));
            }
        }

        return corners.Count < 3 ? [] : InOrder(corners, SamePoint * (width + height));

        RenderingPoint Within(RenderingPoint point) => new(Math.Clamp(point.X, 0.5, right), Math.Clamp(point.Y, 0.5, bottom));
    }

    /// <summary>px^2: area of a polygon.</summary>
    public static double AreaOf(IReadOnlyList<RenderingPoint> polygon)
    {
        double twice = 0.0;
        for (int i = 1; i + 1 < polygon.Count; i++)
        {
            (RenderingPoint from, RenderingPoint to) = (polygon[i], polygon[i + 1]);
            twice += ((from.X - polygon[0].X) * (to.Y - polygon[0].Y)) - ((to.X - polygon[0].X) * (from.Y - polygon[0].Y));
        }

        return 0.5 * Math.Abs(twice);
    }

    /// <summary>Adds the anomalies at which cosine * cos + sine * sin is greatest, least, and each of some values.</summary>
    private static void AddEnds(List<double> ends, double cosine, double sine, ReadOnlySpan<double> values)
    {
        double reach = double.Hypot(cosine, sine);
        double farthest = Trigonometry.Atan2(sine, cosine);
        Add(farthest);
        Add(farthest + Math.PI);
        foreach (double value in values)
        {
            double rest = (reach - value) * (reach + value);
            if (rest > 0.0)
            {
                double half = Trigonometry.Atan2(Math.Sqrt(rest), value);
                Add(farthest - half);
                Add(farthest + half);
            }
        }

        void Add(double anomaly) => ends.Add(anomaly - (2.0 * Math.PI * Math.Floor(anomaly / (2.0 * Math.PI))));
    }

    /// <summary>The corners of a convex polygon around its middle, clockwise as the image is seen, each one once.</summary>
    private static List<RenderingPoint> InOrder(List<RenderingPoint> corners, double samePoint)
    {
        double x = corners.Average(corner => corner.X);
        double y = corners.Average(corner => corner.Y);
        corners.Sort((one, other) => Trigonometry.Atan2(one.Y - y, one.X - x).CompareTo(Trigonometry.Atan2(other.Y - y, other.X - x)));
        List<RenderingPoint> kept = [];
        foreach (RenderingPoint corner in corners)
        {
            if (kept.Count == 0 || double.Hypot(corner.X - kept[^1].X, corner.Y - kept[^1].Y) > samePoint)
            {
                kept.Add(corner);
            }
        }

        if (kept.Count > 1 && double.Hypot(kept[0].X - kept[^1].X, kept[0].Y - kept[^1].Y) <= samePoint)
        {
            kept.RemoveAt(kept.Count - 1);
        }

        return kept;
    }
}
