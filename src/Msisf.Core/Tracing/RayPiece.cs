namespace Msisf.Core.Tracing;

/// <summary>
/// A part of a ray, given by positions along it in m from its nearest approach to the Moon's centre; it is empty if <see cref="Near"/> is
/// beyond <see cref="Far"/>.
/// </summary>
/// <param name="Near">Start of the piece, m.</param>
/// <param name="Far">End of the piece, m.</param>
internal readonly record struct RayPiece(double Near, double Far)
{
    /// <summary>Whether the piece is empty.</summary>
    public bool IsEmpty => !(Near <= Far);

    private static RayPiece Nothing => new(double.PositiveInfinity, double.NegativeInfinity);

    /// <summary>The part of the piece where value + slope s is not below 0, with the position s in m.</summary>
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
