namespace Msisf.Core.Navigation;

/// <summary>Carries the errors of a catalogue over to an ellipse in the image.</summary>
internal static class CraterCovariance
{
    /// <summary>1: relative to the crater's radius, the change over which differences are taken; their error is its square.</summary>
    private const double Step = 1e-5;

    /// <summary>1: least difference of the two axes, relative to the larger; with less the angle turns too fast with the errors.</summary>
    private const double LeastFlattening = 1e-3;

    /// <summary>
    /// Covariance of centre x, y, semi-major and semi-minor axis, angle; null if the ellipse has no angle, or none can be seen.
    /// </summary>
    /// <param name="see">How a disc is seen; null if it is not seen as an ellipse.</param>
    /// <param name="errors">Its errors, taken as independent.</param>
    /// <param name="radius">m: from the Moon's centre to the crater's.</param>
    public static double[]? Of(
        Func<CraterDisc, ImageEllipse?> see, Crater crater, CraterErrors errors, double radius, ImageEllipse ellipse)
    {
        if (ellipse.SemiMajor - ellipse.SemiMinor < LeastFlattening * ellipse.SemiMajor)
        {
            return null;
        }

        double step = Step * 0.5 * crater.Diameter;
        double degrees = double.RadiansToDegrees(step / radius);
        double alongParallel = degrees / Math.Max(Step, Trigonometry.Cos(double.DegreesToRadians(crater.LatitudeDegrees)));
        double turn = double.RadiansToDegrees(Step);
        bool isCircle = crater.MinorDiameter == crater.Diameter && errors.MinorDiameter == 0.0;
        double[]?[] columns =
        [
            Column(degrees, errors.LatitudeDegrees, by => crater with { LatitudeDegrees = crater.LatitudeDegrees + by }),
            Column(alongParallel, errors.LongitudeDegrees, by => crater with { LongitudeDegrees = crater.LongitudeDegrees + by }),
            Column(step, errors.Diameter, by => crater with
            {
                Diameter = crater.Diameter + by, MinorDiameter = crater.MinorDiameter + (isCircle ? by : 0.0),
            }),
            Column(step, errors.MinorDiameter, by => crater with { MinorDiameter = crater.MinorDiameter + by }),
            Column(turn, errors.AngleDegrees, by => crater with { AngleDegrees = crater.AngleDegrees + by }),
        ];
        return Array.TrueForAll(columns, column => column is not null) ? SumOfSquares(columns!) : null;

        double[]? Column(double by, double deviation, Func<double, Crater> moved)
        {
            if (see(CraterDisc.Of(moved(by), radius)) is not { } after || see(CraterDisc.Of(moved(-by), radius)) is not { } before)
            {
                return null;
            }

            double factor = deviation / (2.0 * by);
            return
            [
                factor * (after.X - before.X), factor * (after.Y - before.Y), factor * (after.SemiMajor - before.SemiMajor),
                factor * (after.SemiMinor - before.SemiMinor),
                factor * Math.IEEERemainder(after.Angle - before.Angle, Math.PI), // an axis has no direction
            ];
        }
    }

    private static double[] SumOfSquares(double[][] columns)
    {
        int size = columns.Length;
        double[] sums = new double[size * size];
        for (int row = 0; row < size; row++)
        {
            for (int column = 0; column < size; column++)
            {
                sums[(row * size) + column] = columns.Sum(each => each[row] * each[column]);
            }
        }

        return sums;
    }
}
