namespace Msisf.Core.Numerics;

/// <summary>Sine and cosine of one angle; <c>default</c> is no angle.</summary>
public readonly record struct SineCosine(double Sine, double Cosine)
{
    /// <summary>Sine and cosine of numerator / denominator degrees, by <see cref="DegreeTrigonometry"/>.</summary>
    public static SineCosine OfDegrees(long numerator, long denominator) =>
        new(DegreeTrigonometry.Sin(numerator, denominator), DegreeTrigonometry.Cos(numerator, denominator));
}
