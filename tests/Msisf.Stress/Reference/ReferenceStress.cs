using Msisf.Core.Orbit;

namespace Msisf.Stress.Reference;

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
        "The double-double arithmetic that the tests below measure with: "
            + "its functions, residuals of Kepler's equation and orbits, against mpmath at 60 digits (tests/reference/stress.py).";

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
                Worst("residuals.csv", residuals, ResidualError).ToFigure(
                    "residual of Kepler's equation, of M less its turns", "", Residuals),
                Worst("orbits.csv", orbits, OrbitError).ToFigure("position and velocity, of their length", "", Orbits),
            ],
            []);
    }

    private static WorstCase Worst(string fileName, double[][] rows, Func<double[], double> errorOf)
    {
        WorstCase worst = new();
        for (int index = 0; index < rows.Length; index++)
        {
            worst.Note(errorOf(rows[index]), () => $"tests/golden/stress/{fileName}, line {index + 2}");
        }

        return worst;
    }

    private static double FunctionError(double[] row)
    {
        DoubleWord x = row[0];
        DoubleWord y = row[7];
        (DoubleWord sin, DoubleWord cos) = PreciseMath.SinCos(x);
        return new[]
        {
            Math.Abs((sin - StressTable.Number(row, 1)).High),
            Math.Abs((cos - StressTable.Number(row, 3)).High),
            RelativeError(PreciseMath.MinusSine(x), StressTable.Number(row, 5)),
            RelativeError(DoubleWord.Sqrt(y), StressTable.Number(row, 8)),
            RelativeError(x / y, StressTable.Number(row, 10)),
        }.Aggregate(Math.Max); // unlike Max it keeps NaN
    }

    private static double ResidualError(double[] row)
    {
        DoubleWord reduced = PreciseMath.ToHalfTurn(row[1]);
        DoubleWord residual = PreciseKepler.Residual(row[0], row[2], reduced);
        double difference = (residual - StressTable.Number(row, 3)).High;
        return Math.Max(Math.Abs(difference / row[5]), RelativeError(reduced, StressTable.Number(row, 5)));
    }

    private static double OrbitError(double[] row)
    {
        PreciseOrbit orbit = new(new KeplerElements(row[0], row[1], row[2], row[3], row[4], row[5]));
        (PreciseVector position, PreciseVector velocity) = orbit.StateAt(row[6]);
        PreciseVector rightPosition = new(StressTable.Number(row, 7), StressTable.Number(row, 9), StressTable.Number(row, 11));
        PreciseVector rightVelocity = new(StressTable.Number(row, 13), StressTable.Number(row, 15), StressTable.Number(row, 17));
        return Math.Max(PreciseVector.RelativeError(position, rightPosition), PreciseVector.RelativeError(velocity, rightVelocity));
    }

    private static double RelativeError(DoubleWord found, DoubleWord right) => Math.Abs((found - right).High / right.High);
}
