using System.Numerics;

namespace Msisf.Core.Numerics;

/// <summary>
/// Sobol's points: they fill the unit cube more evenly than random ones, whatever part of them from the first on is taken. Each point is
/// computed by its number. A seed shifts all points alike.
/// </summary>
/// <remarks>
/// Primitive polynomials and first direction numbers: S. Joe, F. Y. Kuo, SIAM J. Sci. Comput. 30 (2008) 2635, new-joe-kuo-6.21201. The
/// shift is digital: an exclusive or of all binary digits, which keeps how evenly the points lie.
/// </remarks>
internal sealed class SobolSequence
{
    /// <summary>Maximum number of coordinates.</summary>
    public const int MaxDimensions = 16;

    private const int Bits = 53;
    private const ulong Purpose = 0x536F626F6C;

    /// <summary>Coefficients of each primitive polynomial between the first and the last, and the first direction numbers.</summary>
    private static readonly (int Polynomial, int[] First)[] Table =
    [
        (0, [1]), (1, [1, 3]), (1, [1, 3, 1]), (2, [1, 1, 1]), (1, [1, 1, 3, 3]), (4, [1, 3, 5, 13]), (2, [1, 1, 5, 5, 17]),
        (4, [1, 1, 5, 5, 5]), (7, [1, 1, 7, 11, 19]), (11, [1, 1, 5, 1, 1]), (13, [1, 1, 1, 3, 11]), (14, [1, 3, 5, 5, 31]),
        (1, [1, 3, 3, 9, 7, 49]), (13, [1, 1, 1, 15, 21, 21]), (16, [1, 3, 1, 13, 27, 49]),
    ];

    private static readonly ulong[][] Directions =
    [
        [.. Enumerable.Range(1, Bits).Select(bit => 1UL << (Bits - bit))],
        .. Table.Select(row => DirectionsOf(row.Polynomial, row.First)),
    ];

    private readonly ulong[] _shift;

    /// <summary>Chooses the sequence.</summary>
    /// <param name="dimensions">Number of coordinates, at most <see cref="MaxDimensions"/>.</param>
    /// <param name="seed">Shifts the points; null for Sobol's own, the first of which is 0.</param>
    /// <param name="stream">Tells sequences of one seed apart.</param>
    public SobolSequence(int dimensions, ulong? seed, long stream = 0)
    {
        ArgumentOutOfRangeException.ThrowIfGreaterThan(dimensions, MaxDimensions);
        _shift = [.. Enumerable.Range(0, dimensions).Select(dimension => seed is { } number
            ? SplitMix64.For(number, Purpose, stream, dimension).NextBits() >> (64 - Bits)
            : 0UL)];
    }

    /// <summary>The coordinates of a point, [0, 1).</summary>
    /// <param name="number">From 0.</param>
    public double[] PointAt(long number)
    {
        double[] point = new double[_shift.Length];
        ulong gray = (ulong)number ^ ((ulong)number >> 1);
        for (int dimension = 0; dimension < point.Length; dimension++)
        {
            ulong digits = _shift[dimension];
            for (ulong left = gray; left != 0; left &= left - 1)
            {
                digits ^= Directions[dimension][BitOperations.TrailingZeroCount(left)];
            }

            point[dimension] = digits * (1.0 / (1UL << Bits));
        }

        return point;
    }

    private static ulong[] DirectionsOf(int polynomial, int[] first)
    {
        int degree = first.Length;
        ulong[] directions = new ulong[Bits];
        for (int bit = 0; bit < Bits; bit++)
        {
            if (bit < degree)
            {
                directions[bit] = (ulong)first[bit] << (Bits - 1 - bit);
                continue;
            }

            ulong next = directions[bit - degree] ^ (directions[bit - degree] >> degree);
            for (int term = 1; term < degree; term++)
            {
                next ^= ((polynomial >> (degree - 1 - term)) & 1) == 1 ? directions[bit - term] : 0UL;
            }

            directions[bit] = next;
        }

        return directions;
    }
}
