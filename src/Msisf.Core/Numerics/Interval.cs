namespace Msisf.Core.Numerics;

/// <summary>
/// All numbers from one to another, both included. Results hold all values that the operands' numbers can give, but for rounding: whoever
/// proves something by them adds <see cref="Tolerances.IntervalRounding"/>.
/// </summary>
/// <param name="Low">The least; may be minus infinity.</param>
/// <param name="High">The greatest; may be infinity.</param>
internal readonly record struct Interval(double Low, double High)
{
    public static Interval Zero => new(0.0, 0.0);

    public static Interval Everything => new(double.NegativeInfinity, double.PositiveInfinity);

    public double Middle => Low == High ? Low : 0.5 * (Low + High);

    /// <summary>Half of the width.</summary>
    public double Radius => Low == High ? 0.0 : 0.5 * (High - Low);

    /// <summary>The greatest absolute value.</summary>
    public double Magnitude => Math.Max(Math.Abs(Low), Math.Abs(High));

    public bool IsFinite => double.IsFinite(Low) && double.IsFinite(High);

    public static Interval Around(double middle, double radius) => new(middle - radius, middle + radius);

    public static implicit operator Interval(double value) => new(value, value);

    public static Interval operator +(Interval a, Interval b) => new(a.Low + b.Low, a.High + b.High);

    public static Interval operator -(Interval a, Interval b) => new(a.Low - b.High, a.High - b.Low);

    public static Interval operator -(Interval a) => new(-a.High, -a.Low);

    public static Interval operator *(Interval a, Interval b)
    {
        (double p, double q) = (Product(a.Low, b.Low), Product(a.Low, b.High));
        (double r, double s) = (Product(a.High, b.Low), Product(a.High, b.High));
        return new Interval(Math.Min(Math.Min(p, q), Math.Min(r, s)), Math.Max(Math.Max(p, q), Math.Max(r, s)));
    }

    /// <summary>Everything where the divisor may be 0 or less.</summary>
    public static Interval operator /(Interval a, Interval b) =>
        b.Low > 0.0 ? a * new Interval(1.0 / b.High, 1.0 / b.Low) : Everything;

    /// <summary>The least interval that holds both.</summary>
    public Interval Hull(Interval other) => new(Math.Min(Low, other.Low), Math.Max(High, other.High));

    /// <summary>What both hold; they must have a number in common, but for rounding.</summary>
    public Interval Both(Interval other)
    {
        (double low, double high) = (Math.Max(Low, other.Low), Math.Min(High, other.High));
        return low <= high ? new Interval(low, high) : 0.5 * (low + high);
    }

    /// <summary>Its part within limits; the nearest limit if there is none.</summary>
    public Interval Clamp(double least, double greatest) => new(Math.Clamp(Low, least, greatest), Math.Clamp(High, least, greatest));

    /// <summary>0 times infinity is 0: an infinite slope of a quantity that does not change.</summary>
    private static double Product(double a, double b) => a == 0.0 || b == 0.0 ? 0.0 : a * b;
}
