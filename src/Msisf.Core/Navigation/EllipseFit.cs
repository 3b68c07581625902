using MathNet.Numerics.LinearAlgebra;
using Msisf.Core.Camera;

namespace Msisf.Core.Navigation;

/// <summary>The ellipse that fits a curve, by least squares.</summary>
internal static class EllipseFit
{
    private const int Unknowns = 5;

    /// <summary>Finds the ellipse.</summary>
    /// <param name="curve">Points around it, at least six.</param>
    /// <param name="residual">px: root mean square distance of the points from it.</param>
    /// <returns>False if no ellipse fits.</returns>
    /// <remarks>
    /// The points are moved, turned and stretched first so that they lie about the unit circle. There the conic
    /// a x^2 + b x y + c y^2 + d x + e y = 1 that the least squares find is the one that is nearest to the points, to second order in what
    /// is left over.
    /// </remarks>
    public static bool TryFit(IReadOnlyList<RenderingPoint> curve, out ImageEllipse ellipse, out double residual)
    {
        ImageEllipse about = MomentsOf(curve);
        (ellipse, residual) = (default, 0.0);
        if (!(about.SemiMinor > 0.0))
        {
            return false;
        }

        Matrix<double> points = Matrix<double>.Build.Dense(curve.Count, Unknowns);
        for (int i = 0; i < curve.Count; i++)
        {
            (double x, double y) = about.ToUnitCircle(curve[i].X, curve[i].Y);
            (points[i, 0], points[i, 1], points[i, 2], points[i, 3], points[i, 4]) = (x * x, x * y, y * y, x, y);
        }

        Vector<double> conic = points.QR().Solve(Vector<double>.Build.Dense(curve.Count, 1.0));
        if (!TryEllipse(conic, about, out ellipse))
        {
            return false;
        }

        double sum = 0.0;
        foreach (RenderingPoint point in curve)
        {
            double distance = ellipse.DistanceTo(point.X, point.Y);
            sum += distance * distance;
        }

        residual = Math.Sqrt(sum / curve.Count);
        return true;
    }

    /// <summary>The ellipse with the points' middle and twice their moments: of points spread evenly round an ellipse itself.</summary>
    private static ImageEllipse MomentsOf(IReadOnlyList<RenderingPoint> curve)
    {
        double x = curve.Average(point => point.X);
        double y = curve.Average(point => point.Y);
        double weight = Math.Sqrt(2.0 / curve.Count);
        return ImageEllipse.OfShape(x, y, [.. curve.Select(point => (weight * (point.X - x), weight * (point.Y - y)))]);
    }

    /// <summary>The ellipse of a conic in the coordinates in which another one is the unit circle.</summary>
    private static bool TryEllipse(Vector<double> conic, ImageEllipse about, out ImageEllipse ellipse)
    {
        (double xx, double xy, double yy) = (conic[0], 0.5 * conic[1], conic[2]);
        double determinant = (xx * yy) - (xy * xy);
        double x = -0.5 * ((yy * conic[3]) - (xy * conic[4])) / determinant;
        double y = -0.5 * ((xx * conic[4]) - (xy * conic[3])) / determinant;
        double scale = 1.0 + (xx * x * x) + (2.0 * xy * x * y) + (yy * y * y);
        if (!(determinant > 0.0 && xx > 0.0 && scale > 0.0))
        {
            ellipse = default;
            return false;
        }

        // Cholesky of the shape, scale times the inverse of the form; its two columns, back in the image.
        double first = Math.Sqrt(scale * yy / determinant);
        double below = -scale * xy / determinant / first;
        double second = Math.Sqrt(scale / yy);
        RenderingPoint middle = Back(about, x, y);
        ReadOnlySpan<(double X, double Y)> columns = [Way(about, first, below), Way(about, 0.0, second)];
        ellipse = ImageEllipse.OfShape(middle.X, middle.Y, columns);
        return double.IsFinite(ellipse.SemiMajor) && ellipse.SemiMinor > 0.0;
    }

    private static RenderingPoint Back(ImageEllipse about, double x, double y)
    {
        (double right, double down) = Way(about, x, y);
        return new RenderingPoint(about.X + right, about.Y + down);
    }

    private static (double X, double Y) Way(ImageEllipse about, double x, double y)
    {
        (double sin, double cos) = Math.SinCos(about.Angle);
        (double along, double across) = (about.SemiMajor * x, about.SemiMinor * y);
        return ((cos * along) - (sin * across), (sin * along) + (cos * across));
    }
}
