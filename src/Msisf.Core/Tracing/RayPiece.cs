namespace Msisf.Core.Tracing;

/// <summary>
/// A part of a ray, in m along it from its nearest approach to the Moon's centre; empty if <see cref="Near"/> is beyond <see cref="Far"/>.
/// </summary>
/// <param name="Near">m.</param>
/// <param name="Far">m.</param>
internal readonly record struct RayPiece(double Near, double Far)
{
    /// <summary>Nothing is left.</summary>
    public bool IsEmpty => !(Near <= Far);

    private static RayPiece Nothing => new(double.PositiveInfinity, double.NegativeInfinity);

    /// <summary>The part where value + slope s is not below 0.</summary>
    public RayPiece WhereNotNegative(double value, double slope)
    {
        if (slope > 0.0)
        {
            return this with { Near = Math.Max(Near, -value / slope) };
        }

        if (slope < 0.0)
        {
            return this with { Far = Math.Min(Far, -value / slope) };
        }

        return value >= 0.0 ? this : Nothing;
    }
}
