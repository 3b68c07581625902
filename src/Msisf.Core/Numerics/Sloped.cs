namespace Msisf.Core.Numerics;

/// <summary>
/// The values that a function of three variables has in a box of them, and those of its three partial derivatives there: forward
/// differentiation in interval arithmetic.
/// </summary>
/// <param name="Value">Holds all its values.</param>
/// <param name="First">Holds all values of its derivative by the first variable.</param>
/// <param name="Second">By the second.</param>
/// <param name="Third">By the third.</param>
internal readonly record struct Sloped(Interval Value, Interval First, Interval Second, Interval Third)
{
    /// <summary>One of the variables.</summary>
    /// <param name="index">0 to 2.</param>
    public static Sloped Variable(Interval value, int index) => new(
        value, index == 0 ? 1.0 : Interval.Zero, index == 1 ? 1.0 : Interval.Zero, index == 2 ? 1.0 : Interval.Zero);

    public static implicit operator Sloped(double value) => new(value, Interval.Zero, Interval.Zero, Interval.Zero);

    public static Sloped operator +(in Sloped a, in Sloped b) =>
        new(a.Value + b.Value, a.First + b.First, a.Second + b.Second, a.Third + b.Third);

    public static Sloped operator -(in Sloped a, in Sloped b) =>
        new(a.Value - b.Value, a.First - b.First, a.Second - b.Second, a.Third - b.Third);

    public static Sloped operator *(in Sloped a, in Sloped b) => new(
        a.Value * b.Value, (a.First * b.Value) + (a.Value * b.First), (a.Second * b.Value) + (a.Value * b.Second),
        (a.Third * b.Value) + (a.Value * b.Third));

    /// <summary>The divisor is above 0.</summary>
    public static Sloped operator /(in Sloped a, in Sloped b)
    {
        Interval inverse = 1.0 / b.Value;
        return a * b.Then(inverse, -(inverse * inverse));
    }

    /// <summary>A function of this one.</summary>
    /// <param name="value">Holds its values.</param>
    /// <param name="slope">Holds its derivative.</param>
    public Sloped Then(Interval value, Interval slope) => new(value, slope * First, slope * Second, slope * Third);

    /// <summary>A function of this one, of which single values and an interval of the derivative are known.</summary>
    /// <param name="function">Its values; may be infinite at the ends.</param>
    /// <param name="slope">Holds its derivative.</param>
    public Sloped Then(Func<double, double> function, Interval slope)
    {
        (double low, double high) = (function(Value.Low), function(Value.High));
        if (slope.Low >= 0.0)
        {
            return Then(new Interval(low, high), slope);
        }

        return slope.High <= 0.0
            ? Then(new Interval(high, low), slope)
            : Then(function(Value.Middle) + (slope * (Value - Value.Middle)), slope);
    }

    /// <summary>Values within limits.</summary>
    public Sloped Clamp(double least, double greatest) =>
        Value.Low >= least && Value.High <= greatest
            ? this
            : new Sloped(Value.Clamp(least, greatest), First.Hull(0.0), Second.Hull(0.0), Third.Hull(0.0));

    /// <summary>What holds the values of both.</summary>
    public Sloped Hull(in Sloped other) =>
        new(Value.Hull(other.Value), First.Hull(other.First), Second.Hull(other.Second), Third.Hull(other.Third));
}
