using Msisf.Core.Numerics;

namespace Msisf.Synthesis;

/// <summary>How the median slope of a terrain falls with the baseline: tan(slope) ~ baseline^(H - 1).</summary>
/// <param name="TangentAt17Metres">Tangent of the median slope at a baseline of 17 m.</param>
/// <param name="HurstExponent">H, 0 to 1.</param>
/// <remarks>
/// M. A. Rosenburg et al., "Global surface slopes and roughness of the Moon from the Lunar Orbiter Laser Altimeter", JGR 116, E02001
/// (2011).
/// </remarks>
internal sealed record SlopeLaw(double TangentAt17Metres, double HurstExponent)
{
    /// <summary>
    /// m: longest baseline for which the law holds; beyond about a kilometre the Moon's slopes fall faster (Rosenburg et al., figure of
    /// the breakover points).
    /// </summary>
    public const double LongestBaseline = 1000.0;

    private const double BelowMetre = 0.86; // H at most

    private const double ReferenceBaseline = 17.0; // m: between LOLA's neighbouring spots

    /// <summary>The maria: 2.0 degrees at 17 m and H = 0.76.</summary>
    public static SlopeLaw Maria { get; } = new(TangentOfDegrees(2.0), 0.76);

    /// <summary>The highlands: 7.5 degrees at 17 m and H = 0.95.</summary>
    public static SlopeLaw Highlands { get; } = new(TangentOfDegrees(7.5), 0.95);

    /// <summary>Tangent of the median slope at a baseline in m.</summary>
    public double TangentAt(double baseline) =>
        TangentAt17Metres * PortableMath.Pow(baseline / ReferenceBaseline, HurstExponent - 1.0);

    /// <summary>
    /// The same, but below a metre slopes grow at least as with H = 0.86: with the highlands' 0.95 ground would look like snow. Stereo
    /// pictures of Apollo's show 0.5 to 0.8 over millimetres and centimetres (P. Helfenstein, M. K. Shepard, Icarus 141 (1999), 107).
    /// </summary>
    public double TangentOfGroundAt(double baseline) => baseline >= 1.0
        ? TangentAt(baseline)
        : TangentAt(1.0) * PortableMath.Pow(baseline, Math.Min(HurstExponent, BelowMetre) - 1.0);

    private static double TangentOfDegrees(double degrees)
    {
        (double sin, double cos) = PortableMath.SinCosDegrees(degrees);
        return sin / cos;
    }
}
