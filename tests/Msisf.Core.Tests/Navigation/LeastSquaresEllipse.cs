using Msisf.Core.Camera;
using Msisf.Core.Navigation;

namespace Msisf.Core.Tests.Navigation;

/// <summary>
/// The ellipse with the least sum of squared distances from points, by Nelder and Mead's simplex. A distance is that of the nearest of
/// many points of the ellipse, made exact by halving. It shares nothing with <see cref="EllipseFit"/>.
/// </summary>
internal static class LeastSquaresEllipse
{
    private const int Coarse = 48;

    /// <summary>Root mean square distance of points from an ellipse, px.</summary>
    public static double Residual(IReadOnlyList<RenderingPoint> points, double[] ellipse) =>
        Math.Sqrt(points.Average(point => Square(ellipse, point)));

    /// <summary>Centre, half axes and angle of the ellipse that fits best.</summary>
    /// <param name="start">Where the search begins.</param>
    public static double[] Fit(IReadOnlyList<RenderingPoint> points, double[] start)
    {
        double[] best = start;
        for (int round = 0; round < 3; round++)
        {
            best = Simplex(points, best, Math.Pow(10.0, -round));
        }

        return best;
    }

    private static double[] Simplex(IReadOnlyList<RenderingPoint> points, double[] start, double size)
    {
        double[] steps = [0.02 * start[2], 0.02 * start[2], 0.02 * start[2], 0.02 * start[2], 0.05];
        List<(double Cost, double[] At)> simplex = [Valued(start)];
        for (int i = 0; i < start.Length; i++)
        {
            double[] moved = [.. start];
            moved[i] += size * steps[i];
            simplex.Add(Valued(moved));
        }

        for (int step = 0; step < 250; step++)
        {
            simplex.Sort((one, other) => one.Cost.CompareTo(other.Cost));
            double[] middle = [.. Enumerable.Range(0, 5).Select(i => simplex.Take(5).Average(corner => corner.At[i]))];
            (double Cost, double[] At) mirrored = Valued(Along(middle, simplex[5].At, -1.0));
            if (mirrored.Cost < simplex[0].Cost)
            {
                (double Cost, double[] At) farther = Valued(Along(middle, simplex[5].At, -2.0));
                simplex[5] = farther.Cost < mirrored.Cost ? farther : mirrored;
            }
            else if (mirrored.Cost < simplex[4].Cost)
            {
                simplex[5] = mirrored;
            }
            else
            {
                (double Cost, double[] At) nearer = Valued(Along(middle, simplex[5].At, 0.5));
                simplex = nearer.Cost < simplex[5].Cost
                    ? [.. simplex.Take(5), nearer]
                    : [simplex[0], .. simplex.Skip(1).Select(corner => Valued(Along(simplex[0].At, corner.At, 0.5)))];
            }
        }

        return simplex.MinBy(corner => corner.Cost).At;

        (double Cost, double[] At) Valued(double[] at) => (points.Sum(point => Square(at, point)), at);
    }

    private static double[] Along(double[] from, double[] to, double part) => [.. from.Zip(to, (a, b) => a + (part * (b - a)))];

    private static double Square(double[] ellipse, RenderingPoint point)
    {
        double step = 2.0 * Math.PI / Coarse;
        double at = 0.0;
        double least = double.PositiveInfinity;
        for (int index = 0; index < Coarse; index++)
        {
            double square = SquareAt(ellipse, point, step * index);
            (at, least) = square < least ? (step * index, square) : (at, least);
        }

        for (double reach = 0.5 * step; reach > 1e-6; reach *= 0.5)
        {
            double here = SquareAt(ellipse, point, at);
            double before = SquareAt(ellipse, point, at - reach);
            double after = SquareAt(ellipse, point, at + reach);
            at = before < here && before <= after ? at - reach : after < here ? at + reach : at;
        }

        return SquareAt(ellipse, point, at);
    }

    private static double SquareAt(double[] ellipse, RenderingPoint point, double anomaly)
    {
        (double sin, double cos) = Math.SinCos(ellipse[4]);
        (double sinOf, double cosOf) = Math.SinCos(anomaly);
        double right = ellipse[0] + (ellipse[2] * cos * cosOf) - (ellipse[3] * sin * sinOf) - point.X;
        double down = ellipse[1] + (ellipse[2] * sin * cosOf) + (ellipse[3] * cos * sinOf) - point.Y;
        return (right * right) + (down * down);
    }
}
