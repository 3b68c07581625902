using Msisf.Core.Numerics;
using Msisf.Core.Orbit;

namespace Msisf.Stress.Numerics;

/// <summary>The references of the other stress tests, held against mpmath.</summary>
public sealed class ReferenceStress : IStressTest
{
    /// <summary>1: of the number, or of 1 for a sine near 0; some ten roundings of 2^-104.</summary>
    private const double Functions = 1e-30;

    /// <summary>1, of the vector: a phase of up to 1e6 turns has 25 digits left.</summary>
    private const double Orbits = 1e-25;

    /// <summary>1, of M less its turns: those are up to 1e13 times as long, and their multiple of 2 pi has 160 bits.</summary>
    private const double Residuals = 1e-28;

    /// <inheritdoc/>
    public string Name => "reference";

    /// <inheritdoc/>
    public string Subject =>
        "The double-double arithmetic that the tests below measure with: its functions, residuals of Kepler's equation and orbits, against mpmath at 60 digits (tests/reference/stress.py).";

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        double[][] functions = StressTable.Rows("functions.csv");
        double[][] residuals = StressTable.Rows("residuals.csv");
        double[][] orbits = StressTable.Rows("orbits.csv");
        return new StressReport(
            Name,
            functions.Length + residuals.Length + orbits.Length,
            [
                Worst("functions.csv", functions, FunctionError).ToFigure("sine, cosine, x - sin x, root, quotient", "", Functions),
                Worst("residuals.csv", residuals, ResidualError).ToFigure("residual of Kepler's equation, of M less its turns", "", Residuals),
                Worst("orbits.csv", orbits, OrbitError).ToFigure("position and velocity, of their length", "", Orbits),
            ],
            []);
    }

    private static WorstCase Worst(string fileName, double[][] rows, Func<double[], double> errorOf)
    {
        WorstCase worst = new();
        for (int index = 0; index < rows.Length; index++)
        {
            double error = errorOf(rows[index]);
            if (worst.IsBeatenBy(error))
            {
                worst.Take(error, FormattableString.Invariant($"tests/golden/stress/{fileName}, line {index + 2}"));
            }
        }

        return worst;
    }

    private static double FunctionError(double[] row)
    {
        DoubleDouble x = WideMath.Of(row[0]);
        DoubleDouble y = WideMath.Of(row[7]);
        (DoubleDouble sin, DoubleDouble cos) = WideMath.SinCos(x);
        return new[]
        {
            Math.Abs(WideMath.Subtract(sin, StressTable.Wide(row, 1)).High),
            Math.Abs(WideMath.Subtract(cos, StressTable.Wide(row, 3)).High),
            RelativeError(WideMath.MinusSine(x), StressTable.Wide(row, 5)),
            RelativeError(WideMath.SquareRoot(y), StressTable.Wide(row, 8)),
            RelativeError(WideMath.Divide(x, y), StressTable.Wide(row, 10)),
        }.Aggregate(Math.Max); // unlike Max it keeps NaN
    }

    private static double ResidualError(double[] row)
    {
        DoubleDouble reduced = WideMath.ToHalfTurn(WideMath.Of(row[1]));
        DoubleDouble residual = WideKepler.Residual(WideMath.Of(row[0]), row[2], reduced);
        double difference = WideMath.Subtract(residual, StressTable.Wide(row, 3)).High;
        return Math.Max(Math.Abs(difference / row[5]), RelativeError(reduced, StressTable.Wide(row, 5)));
    }

    private static double OrbitError(double[] row)
    {
        WideOrbit orbit = new(new KeplerElements(row[0], row[1], row[2], row[3], row[4], row[5]));
        (WideVector position, WideVector velocity) = orbit.StateAt(WideMath.Of(row[6]));
        WideVector rightPosition = new(StressTable.Wide(row, 7), StressTable.Wide(row, 9), StressTable.Wide(row, 11));
        WideVector rightVelocity = new(StressTable.Wide(row, 13), StressTable.Wide(row, 15), StressTable.Wide(row, 17));
        return Math.Max(
            WideVector.Distance(position, rightPosition) / rightPosition.Length.High,
            WideVector.Distance(velocity, rightVelocity) / rightVelocity.Length.High);
    }

    private static double RelativeError(DoubleDouble found, DoubleDouble right) => Math.Abs(WideMath.Subtract(found, right).High / right.High);
}
