using MathNet.Numerics.LinearAlgebra;
using Msisf.Core.Camera;

namespace Msisf.Core.Navigation;

/// <summary>The ellipse that fits a curve by least squares: the sum of the squared distances in the image is least.</summary>
internal static class EllipseFit
{
    private const int Unknowns = 5;

    /// <summary>Steps after which the fit ends; each one leaves at most some hundredths of the error where a rim has an ellipse.</summary>
    private const int MostSteps = 100;

    /// <summary>1: relative to the major axis, the step at which the fit ends; far above rounding.</summary>
    private const double LeastStep = 1e-13;

    /// <summary>Finds the ellipse.</summary>
    /// <param name="curve">Points around it, at least six.</param>
    /// <param name="residual">px: root mean square distance of the points from it.</param>
    /// <returns>False if no ellipse fits.</returns>
    /// <remarks>
    /// It begins with the conic a x^2 + b x y + c y^2 + d x + e y = 1 that fits the points when they are moved, turned and stretched to
    /// lie about the unit circle. Then Gauss and Newton's steps reduce the distances themselves: S. J. Ahn, W. Rauh, H.-J. Warnecke,
    /// Pattern Recognition 34 (2001) 2283. The unknowns of a step are the shift of the centre and a symmetric stretch of the ellipse,
    /// which are well defined for a circle, too.
    /// </remarks>
    public static bool TryFit(IReadOnlyList<RenderingPoint> curve, out ImageEllipse ellipse, out double residual)
    {
        residual = 0.0;
        if (!TryConic(curve, out ellipse))
        {
            return false;
        }

        double sum = SumOfSquares(curve, ellipse);
        for (int step = 0; step < MostSteps; step++)
        {
            Vector<double> change = StepOf(curve, ellipse);
            double part = 1.0;
            bool isBetter = false;
            for (; !isBetter && part * change.L1Norm() > LeastStep * ellipse.SemiMajor; part *= 0.5)
            {
                ImageEllipse next = Changed(ellipse, part * change);
                double sumOfNext = next.SemiMinor > 0.0 ? SumOfSquares(curve, next) : double.NaN;
                if (sumOfNext < sum)
                {
                    (ellipse, sum, isBetter) = (next, sumOfNext, true);
                }
            }

            if (!isBetter)
            {
                break;
            }
        }

        residual = Math.Sqrt(sum / curve.Count);
        return double.IsFinite(residual);
    }

    private static double SumOfSquares(IReadOnlyList<RenderingPoint> curve, ImageEllipse ellipse)
    {
        double sum = 0.0;
        for (int i = 0; i < curve.Count; i++)
        {
            double distance = ellipse.DistanceTo(curve[i].X, curve[i].Y);
            sum += distance * distance;
        }

        return sum;
    }

    /// <summary>A step of Gauss and Newton: the shift of the centre, and the stretch along, between and across the axes; px.</summary>
    private static Vector<double> StepOf(IReadOnlyList<RenderingPoint> curve, ImageEllipse ellipse)
    {
        (double sin, double cos) = Trigonometry.SinCos(ellipse.Angle);
        Matrix<double> squares = Matrix<double>.Build.Dense(Unknowns, Unknowns);
        Vector<double> products = Vector<double>.Build.Dense(Unknowns);
        Span<double> slopes = stackalloc double[Unknowns];
        for (int i = 0; i < curve.Count; i++)
        {
            (double sinOf, double cosOf) = ellipse.AnomalyNearest(curve[i].X, curve[i].Y);

            // The normal at the nearest point, along and across the axes; a stretch moves that point by axes * stretch * (cos, sin).
            double length = double.Hypot(ellipse.SemiMinor * cosOf, ellipse.SemiMajor * sinOf);
            (double along, double across) = (ellipse.SemiMinor * cosOf / length, ellipse.SemiMajor * sinOf / length);
            (double right, double down) = ((cos * along) - (sin * across), (sin * along) + (cos * across));
            RenderingPoint nearest = ellipse.PointAt(sinOf, cosOf);
            double distance = (right * (curve[i].X - nearest.X)) + (down * (curve[i].Y - nearest.Y));
            double flat = ellipse.SemiMinor / ellipse.SemiMajor;
            (slopes[0], slopes[1]) = (right, down);
            (slopes[2], slopes[3], slopes[4]) = (along * cosOf, (along * sinOf) + (across * flat * cosOf), across * flat * sinOf);
            for (int row = 0; row < Unknowns; row++)
            {
                products[row] += slopes[row] * distance;
                for (int column = 0; column < Unknowns; column++)
                {
                    squares[row, column] += slopes[row] * slopes[column];
                }
            }
        }

        return squares.LU().Solve(products);
    }

    private static ImageEllipse Changed(ImageEllipse ellipse, Vector<double> change) => ImageEllipse.OfShape(
        ellipse.X + change[0],
        ellipse.Y + change[1],
        [
            Way(ellipse, 1.0 + (change[2] / ellipse.SemiMajor), change[3] / ellipse.SemiMajor),
            Way(ellipse, change[3] / ellipse.SemiMajor, 1.0 + (change[4] / ellipse.SemiMajor)),
        ]);

    /// <summary>The ellipse whose conic fits the points when they lie about the unit circle.</summary>
    private static bool TryConic(IReadOnlyList<RenderingPoint> curve, out ImageEllipse ellipse)
    {
        ImageEllipse about = MomentsOf(curve);
        ellipse = default;
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

        return TryEllipse(points.QR().Solve(Vector<double>.Build.Dense(curve.Count, 1.0)), about, out ellipse);
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
        (double sin, double cos) = Trigonometry.SinCos(about.Angle);
        (double along, double across) = (about.SemiMajor * x, about.SemiMinor * y);
        return ((cos * along) - (sin * across), (sin * along) + (cos * across));
    }
}
