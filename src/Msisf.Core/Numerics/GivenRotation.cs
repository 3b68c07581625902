namespace Msisf.Core.Numerics;

/// <summary>Takes rotation matrices whose numbers a user gives, so that they are rounded or wrong.</summary>
public static class GivenRotation
{
    /// <summary>Each step doubles the right digits: from an error of 0.01 to that of doubles.</summary>
    private const int Steps = 5;

    /// <summary>The rotation that is nearest to a matrix.</summary>
    /// <param name="numbers">Nine numbers by rows, finite.</param>
    /// <param name="isRounded">Whether they may be rounded to a few decimals.</param>
    /// <exception cref="BadInputException">
    /// The matrix is further than <see cref="Tolerances.RotationMatrixEntry"/>, a rounded one than
    /// <see cref="Tolerances.RoundedRotation"/>, from a rotation, or turns right-handed axes into left-handed ones.
    /// </exception>
    public static UnitQuaternion OfMatrix(ReadOnlySpan<double> numbers, bool isRounded)
    {
        RotationMatrix matrix = new(
            new Vector3D(numbers[0], numbers[1], numbers[2]),
            new Vector3D(numbers[3], numbers[4], numbers[5]),
            new Vector3D(numbers[6], numbers[7], numbers[8]));
        double error = ErrorOf(matrix);
        if (!(error <= (isRounded ? Tolerances.RoundedRotation : Tolerances.RotationMatrixEntry)))
        {
            string cure = error <= Tolerances.RoundedRotation
                ? "write each number with at least 7 decimals, or give --normalize."
                : "rounding does not explain it; check the numbers and their order.";
            throw new BadInputException(Invariant(
                $"The matrix is not a rotation: the products of its rows are wrong by up to {error:G3}, "
                    + $"{Tolerances.RotationMatrixEntry:R} is allowed: {cure}"));
        }

        if (Determinant(matrix) < 0.0)
        {
            throw new BadInputException(
                "The matrix is a reflection (its determinant is -1), not a rotation: one of the axes points the wrong way.");
        }

        for (int step = 0; step < Steps; step++)
        {
            matrix = Nearer(matrix);
        }

        return UnitQuaternion.FromMatrix(matrix);
    }

    /// <summary>Greatest difference of the products of two rows from those of a rotation, 0 and 1.</summary>
    private static double ErrorOf(RotationMatrix matrix)
    {
        RotationMatrix products = matrix * matrix.Transposed;
        double[] errors =
        [
            products.Row0.X - 1.0, products.Row1.Y - 1.0, products.Row2.Z - 1.0, products.Row0.Y, products.Row0.Z, products.Row1.Z,
        ];
        return errors.Max(Math.Abs);
    }

    private static double Determinant(RotationMatrix m) => Vector3D.Dot(m.Row0, Vector3D.Cross(m.Row1, m.Row2));

    /// <summary>A step of Newton's iteration to the nearest rotation: the mean of the matrix and its inverse's transpose.</summary>
    /// <remarks>N. J. Higham, SIAM J. Sci. Stat. Comput. 7 (1986) 1160, equation 3.2.</remarks>
    private static RotationMatrix Nearer(RotationMatrix m)
    {
        double determinant = Determinant(m);
        return new RotationMatrix(
            0.5 * (m.Row0 + (Vector3D.Cross(m.Row1, m.Row2) / determinant)),
            0.5 * (m.Row1 + (Vector3D.Cross(m.Row2, m.Row0) / determinant)),
            0.5 * (m.Row2 + (Vector3D.Cross(m.Row0, m.Row1) / determinant)));
    }
}
