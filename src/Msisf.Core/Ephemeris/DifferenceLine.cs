using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>Evaluates a record of modified divided differences, as JPL's integrators write them (SPK types 1 and 21).</summary>
/// <remarks>
/// F. T. Krogh, "Changing stepsize in the integration of differential equations using modified divided differences" (1974); the layout
/// of a record is in NAIF's SPK Required Reading, types 1 and 21.
/// </remarks>
public static class DifferenceLine
{
    /// <summary>Numbers of a record with tables of a size.</summary>
    /// <param name="terms">Number of terms of each table; 15 in type 1.</param>
    public static int Words(int terms) => (4 * terms) + 11;

    /// <summary>The state at a time.</summary>
    /// <param name="terms">Number of terms of each table.</param>
    /// <returns>km, km/s.</returns>
    /// <exception cref="BadInputException">The record contradicts itself.</exception>
    public static StateVector Evaluate(ReadOnlySpan<double> record, int terms, TdbTime time)
    {
        double delta = time - record[0];
        ReadOnlySpan<double> steps = record.Slice(1, terms);
        ReadOnlySpan<double> reference = record.Slice(1 + terms, 6); // x, x', y, y', z, z'
        ReadOnlySpan<double> tables = record.Slice(7 + terms, 3 * terms);
        ReadOnlySpan<double> orders = record.Slice(7 + (4 * terms), 4); // the largest one + 1, then one for each axis
        double most = orders[0];
        if (!(most >= 2.0 && most <= terms + 1.0) || orders[1..].ContainsAnyExceptInRange(0.0, most - 1.0))
        {
            throw new BadInputException("a record of differences whose orders are out of range");
        }

        int order = (int)most - 1;
        Span<double> factors = stackalloc double[order];
        Span<double> ratios = stackalloc double[order];
        double sum = delta;
        for (int j = 0; j < order - 1; j++)
        {
            if (steps[j] == 0.0)
            {
                throw new BadInputException("a record of differences with a step of 0");
            }

            (factors[j], ratios[j]) = (sum / steps[j], delta / steps[j]);
            sum = delta + steps[j];
        }

        // weights[j + k] are the integrals of order k of the j-th difference's polynomial, from the order of the method down.
        Span<double> weights = stackalloc double[(2 * order) + 2];
        for (int j = 0; j <= order; j++)
        {
            weights[j] = 1.0 / (j + 1.0);
        }

        int level = order;
        int count = 0;
        for (; level >= 2; level--)
        {
            Lower(weights, ++count, level, factors, ratios);
        }

        Span<double> position = stackalloc double[3];
        Span<double> velocity = stackalloc double[3];
        for (int axis = 0; axis < 3; axis++)
        {
            double part = Sum(tables.Slice(axis * terms, terms), weights, (int)orders[axis + 1], 1);
            position[axis] = reference[2 * axis] + (delta * (reference[(2 * axis) + 1] + (delta * part)));
        }

        Lower(weights, count, 1, factors, ratios);
        for (int axis = 0; axis < 3; axis++)
        {
            velocity[axis] = reference[(2 * axis) + 1]
                + (delta * Sum(tables.Slice(axis * terms, terms), weights, (int)orders[axis + 1], 0));
        }

        return new StateVector(new Vector3D(position[0], position[1], position[2]), new Vector3D(velocity[0], velocity[1], velocity[2]));
    }

    private static void Lower(Span<double> weights, int count, int level, ReadOnlySpan<double> factors, ReadOnlySpan<double> ratios)
    {
        for (int j = 1; j <= count; j++)
        {
            weights[j + level - 1] = (factors[j - 1] * weights[j + level - 2]) - (ratios[j - 1] * weights[j + level - 1]);
        }
    }

    private static double Sum(ReadOnlySpan<double> table, ReadOnlySpan<double> weights, int order, int level)
    {
        double sum = 0.0;
        for (int j = order; j >= 1; j--)
        {
            sum += table[j - 1] * weights[j + level - 1];
        }

        return sum;
    }
}
