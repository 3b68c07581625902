namespace Msisf.Core.Numerics;

/// <summary>
/// Sines, cosines and arc tangents for what is written, the same on every system. The C library of Linux is right to 0.55 units in the last
/// place. That of Windows may be off by a whole one, so sums of two doubles take its place.
/// </summary>
public static class Trigonometry
{
    /// <summary>Terms of the series; the first one left out is below 2^-100 on [-pi/4, pi/4].</summary>
    private const int Terms = 28;

    /// <summary>Beyond, products of two doubles may overflow or lose bits.</summary>
    private const double SafeLimit = 1e140;

    /// <summary>pi / 2, and what its rounding to two doubles lost (mpmath, 60 digits).</summary>
    private const double QuarterTurnRest = -1.4973849048591698e-33;

    private static readonly DoubleDouble QuarterTurn = new(1.5707963267948966, 6.123233995736766e-17);
    private static readonly DoubleDouble One = new(1.0, 0.0);

    /// <summary>-1 / (n (n - 1)) by n.</summary>
    private static readonly DoubleDouble[] Ratios =
        [.. Enumerable.Range(0, Terms + 1).Select(n => n < 2 ? default : DoubleDouble.Quotient(-1.0, n * (n - 1.0)))];

    /// <summary>Sine of an angle in rad.</summary>
    public static double Sin(double angle) => OperatingSystem.IsWindows() ? AccurateSinCos(angle).Sin : Math.Sin(angle);

    /// <summary>Cosine of an angle in rad.</summary>
    public static double Cos(double angle) => OperatingSystem.IsWindows() ? AccurateSinCos(angle).Cos : Math.Cos(angle);

    /// <summary>Both, of an angle in rad.</summary>
    public static (double Sin, double Cos) SinCos(double angle) =>
        OperatingSystem.IsWindows() ? AccurateSinCos(angle) : Math.SinCos(angle);

    /// <summary>The angle of the vector (x, y) from the x axis, rad, -pi to pi.</summary>
    public static double Atan2(double y, double x) => OperatingSystem.IsWindows() ? AccurateAtan2(y, x) : Math.Atan2(y, x);

    /// <summary>Sine and cosine with two doubles, hardly ever rounded the wrong way; from 1e5 rad on as the system has them.</summary>
    internal static (double Sin, double Cos) AccurateSinCos(double angle)
    {
        if (angle == 0.0 || !(Math.Abs(angle) < 1e5))
        {
            return Math.SinCos(angle);
        }

        (DoubleDouble sin, DoubleDouble cos) = SinCosOf(angle);
        return (sin.High, cos.High);
    }

    /// <summary>Arc tangent by one step of Newton's method with two doubles from that of the system.</summary>
    internal static double AccurateAtan2(double y, double x)
    {
        double near = Math.Atan2(y, x);
        double largest = Math.Max(Math.Abs(y), Math.Abs(x));
        if (near == 0.0 || !(largest is > 1.0 / SafeLimit and < SafeLimit) || Math.Abs(y) < 1.0 / SafeLimit)
        {
            return near;
        }

        (DoubleDouble sin, DoubleDouble cos) = SinCosOf(near);
        DoubleDouble across = (new DoubleDouble(y, 0.0) * cos) + (new DoubleDouble(-x, 0.0) * sin);
        double along = (x * cos.High) + (y * sin.High);
        return (new DoubleDouble(near, 0.0) + new DoubleDouble(across.High / along, 0.0)).High;
    }

    private static (DoubleDouble Sin, DoubleDouble Cos) SinCosOf(double angle)
    {
        double quarters = Math.Floor((angle / QuarterTurn.High) + 0.5);
        DoubleDouble rest = new DoubleDouble(angle, 0.0) + (new DoubleDouble(-quarters, 0.0) * QuarterTurn)
            + new DoubleDouble(-quarters * QuarterTurnRest, 0.0);
        DoubleDouble square = rest * rest;
        DoubleDouble sin = One;
        DoubleDouble cos = One;
        for (int n = Terms; n >= 2; n -= 2)
        {
            cos = One + (cos * square * Ratios[n]);
            sin = n > 2 ? One + (sin * square * Ratios[n - 1]) : sin;
        }

        sin = rest * sin;
        return ((long)quarters & 3) switch
        {
            0 => (sin, cos),
            1 => (cos, Minus(sin)),
            2 => (Minus(sin), Minus(cos)),
            _ => (Minus(cos), sin),
        };
    }

    private static DoubleDouble Minus(DoubleDouble value) => new(-value.High, -value.Low);
}
