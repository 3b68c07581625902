namespace Msisf.Core.Numerics;

/// <summary>Reduces an angle by full turns without loss of digits.</summary>
public static class AngleReduction
{
    /// <summary>2 pi is this plus <see cref="TurnMiddle"/> plus <see cref="TurnLow"/>, to 160 bits (mpmath, 80 digits).</summary>
    private const double TurnHigh = 6.283185307179586;
    private const double TurnMiddle = 2.4492935982947064e-16;
    private const double TurnLow = -5.989539619436679e-33;

    /// <summary>
    /// Maximum number of turns for the reduction in parts; up to here turns * <see cref="TurnHigh"/> fits into two doubles.
    /// </summary>
    private const double MaxTurnsByParts = 1L << 40;

    /// <summary>The same direction in [-pi, pi].</summary>
    /// <param name="angle">rad, finite; taken as exact, and in that range it comes back as it is.</param>
    /// <param name="correction">rad, finite: digits of the angle that did not fit into <paramref name="angle"/>.</param>
    /// <remarks>W. J. Cody, W. Waite, "Software Manual for the Elementary Functions" (1980), with fused multiply-add.</remarks>
    public static double ToHalfTurn(double angle, double correction = 0.0)
    {
        double turns = Math.Round(angle / TurnHigh);
        if (Math.Abs(turns) > MaxTurnsByParts)
        {
            // The library's sine and cosine are right for any argument, which costs about one unit in the last place here.
            return ToHalfTurn(Trigonometry.Atan2(Trigonometry.Sin(angle), Trigonometry.Cos(angle)), ToHalfTurn(correction));
        }

        // Exact: the difference is a multiple of angle's or TurnHigh's last bit, and small enough for 53 of them.
        double remainder = Math.FusedMultiplyAdd(-turns, TurnHigh, angle);
        double middle = turns * TurnMiddle;
        double middleError = Math.FusedMultiplyAdd(turns, TurnMiddle, -middle);
        double difference = remainder - middle;
        double subtracted = remainder - difference;
        double lost = (remainder - (difference + subtracted)) + (subtracted - middle);
        double reduced = difference + (lost - middleError - (turns * TurnLow) + correction);
        return Math.Abs(reduced) > Math.PI && (turns != 0.0 || correction != 0.0) ? ToHalfTurn(reduced) : reduced;
    }

    /// <summary>The same direction in [0, 2 pi).</summary>
    /// <param name="angle">rad, finite.</param>
    public static double ToFullTurn(double angle) => FullTurnOfHalf(ToHalfTurn(angle));

    /// <summary>The same direction in [0, 2 pi) of an angle that lies in [-pi, pi] already, as arctangents do.</summary>
    /// <param name="reduced">rad, [-pi, pi].</param>
    internal static double FullTurnOfHalf(double reduced)
    {
        double positive = reduced < 0.0 ? reduced + TurnHigh : reduced;

        // A tiny negative angle rounds to 2 pi; adding 0 makes -0 the plain zero.
        return positive >= TurnHigh ? 0.0 : positive + 0.0;
    }
}
