namespace Msisf.Core.Numerics;

/// <summary>
/// Kronecker's points: they fill the unit cube more evenly than random ones, however many of them are taken, from whichever on. So do the
/// sums and differences of any two coordinates. Each point is computed by its number. A seed shifts all points alike.
/// </summary>
/// <remarks>
/// A coordinate of point n is the fractional part of n a + shift (L. Kuipers, H. Niederreiter, "Uniform Distribution of Sequences", 1974,
/// chapter 2). It is even if the continued fraction of a has small partial quotients. tests/reference/kronecker.py chose the numbers a so
/// that this is true of each, and of all their sums and differences. All is exact in whole numbers modulo 2^64.
/// </remarks>
internal sealed class KroneckerSequence
{
    /// <summary>Maximum number of coordinates.</summary>
    public const int MaxDimensions = 16;

    private const int Bits = 53;
    private const ulong Purpose = 0x4B726F6E65636B;

    /// <summary>The numbers a, in steps of 2^-64.</summary>
    private static readonly ulong[] Steps =
    [
        0x98D9_DAC3_7434_2801, 0xEF65_6278_051F_0801, 0xA561_FEC0_542A_6801, 0xBE46_5ECE_5611_E001,
        0x5424_4045_29F5_0801, 0x28A6_0FE9_3426_6001, 0xEA87_A553_D606_C801, 0xF1F1_2C93_EF3F_0801,
        0xCF21_07A4_B59C_8801, 0x7B5F_DFB0_B4BC_5801, 0x3A6B_9AB8_01E8_4801, 0xE316_3A79_2F03_7801,
        0xD237_7C40_2D20_5801, 0x6CFF_2000_15F4_4001, 0xC954_105B_5117_5801, 0xFD30_21DA_D8D8_3001,
    ];

    private readonly ulong[] _shift;

    /// <summary>Chooses the sequence.</summary>
    /// <param name="dimensions">Number of coordinates, at most <see cref="MaxDimensions"/>.</param>
    /// <param name="seed">Shifts the points.</param>
    /// <param name="stream">Tells sequences of one seed apart.</param>
    public KroneckerSequence(int dimensions, ulong seed, long stream)
    {
        ArgumentOutOfRangeException.ThrowIfGreaterThan(dimensions, MaxDimensions);
        _shift = [.. Enumerable.Range(0, dimensions).Select(dimension => SplitMix64.For(seed, Purpose, stream, dimension).NextBits())];
    }

    /// <summary>The coordinates of a point, [0, 1).</summary>
    /// <param name="number">From 0.</param>
    public double[] PointAt(long number)
    {
        double[] point = new double[_shift.Length];
        for (int dimension = 0; dimension < point.Length; dimension++)
        {
            ulong digits = unchecked(((ulong)number * Steps[dimension]) + _shift[dimension]);
            point[dimension] = (digits >> (64 - Bits)) * (1.0 / (1UL << Bits));
        }

        return point;
    }
}
