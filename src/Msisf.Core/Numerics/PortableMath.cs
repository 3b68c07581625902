namespace Msisf.Core.Numerics;

/// <summary>
/// Elementary functions made of + - * / and whole-number scaling only, so that every IEEE 754 machine gets the same bits;
/// the system's sin, log and pow differ in the last place between C libraries.
/// </summary>
internal static class PortableMath
{
    private const double DegreesToRadians = Math.PI / 180.0;
    private const double Ln2 = 0.69314718055994530942;

    /// <summary>Sine and cosine of an angle in degrees, |angle| below 1e6; absolute error under 4e-16.</summary>
    public static (double Sin, double Cos) SinCosDegrees(double degrees)
    {
        double quarterTurns = Math.Floor((degrees / 90.0) + 0.5);
        double x = (degrees - (90.0 * quarterTurns)) * DegreesToRadians;
        double square = x * x;

        // Taylor series on [-pi/4, pi/4]: the first term left out is below 2^-53.
        double sin = 0.0;
        for (int n = 17; n >= 3; n -= 2)
        {
            sin = (1.0 + sin) * -square / (n * (n - 1));
        }

        double cos = 0.0;
        for (int n = 18; n >= 2; n -= 2)
        {
            cos = (1.0 + cos) * -square / (n * (n - 1));
        }

        sin = x * (1.0 + sin);
        cos = 1.0 + cos;
        return ((long)quarterTurns & 3) switch
        {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        };
    }

    /// <summary>Base-2 logarithm of a positive, normal number; absolute error under 1e-15 for numbers near 1.</summary>
    public static double Log2(double value)
    {
        long bits = BitConverter.DoubleToInt64Bits(value);
        int exponent = (int)(bits >> 52) - 1023;
        double mantissa = BitConverter.Int64BitsToDouble((bits & 0x000F_FFFF_FFFF_FFFF) | 0x3FF0_0000_0000_0000);
        if (mantissa > 1.4142135623730951)
        {
            mantissa *= 0.5;
            exponent++;
        }

        // ln m = 2 artanh((m - 1) / (m + 1)), argument below 0.172: 11 terms.
        double t = (mantissa - 1.0) / (mantissa + 1.0);
        double square = t * t;
        double sum = 0.0;
        for (int n = 21; n >= 1; n -= 2)
        {
            sum = (sum * square) + (1.0 / n);
        }

        return exponent + (2.0 * t * sum / Ln2);
    }

    /// <summary>2 to the given power, within the range of normal numbers; relative error under 1e-15.</summary>
    public static double Exp2(double exponent)
    {
        double whole = Math.Floor(exponent + 0.5);
        double x = (exponent - whole) * Ln2;
        double sum = 1.0;
        for (int n = 15; n >= 1; n--)
        {
            sum = 1.0 + (sum * x / n);
        }

        return Math.ScaleB(sum, (int)whole);
    }

    /// <summary>A positive number to a power.</summary>
    public static double Pow(double value, double exponent) => Exp2(exponent * Log2(value));
}
