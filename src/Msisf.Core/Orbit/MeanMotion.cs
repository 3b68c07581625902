using Msisf.Core.Terrain;

namespace Msisf.Core.Orbit;

/// <summary>
/// The mean motion n = sqrt(mu / a^3) about the Moon to twice the digits of a double, so that M = M0 + n dt stays right after years: with
/// a plain double the position is off by up to 0.3 mm after 30 years in a low orbit. <c>default</c> is a rate of zero.
/// </summary>
public readonly record struct MeanMotion
{
    private readonly double _correction;

    /// <summary>The mean motion of an orbit.</summary>
    /// <param name="semiMajorAxis">a, m, finite and above 0.</param>
    public MeanMotion(double semiMajorAxis)
    {
        // a = scaled * 2^even, so that no power of it overflows.
        int even = Math.ILogB(semiMajorAxis) & ~1;
        double scaled = Math.ScaleB(semiMajorAxis, -even);

        double rate = Math.Sqrt(MoonConstants.GravitationalParameter / (scaled * scaled * scaled));
        double correction = rate * RelativeDefect(rate, scaled) / 2.0;

        RadiansPerSecond = Math.ScaleB(rate, -even / 2 * 3);
        _correction = Math.ScaleB(correction, -even / 2 * 3);
    }

    /// <summary>n, rad/s, as one double.</summary>
    public double RadiansPerSecond { get; }

    /// <summary>The mean anomaly M0 + n dt (thesis eq. 6.1).</summary>
    /// <param name="meanAnomalyAtEpoch">M0, rad, finite.</param>
    /// <param name="secondsSinceEpoch">dt, s, finite, may be negative.</param>
    /// <returns>rad, [-pi, pi].</returns>
    /// <exception cref="BadInputException">n dt is beyond the largest double.</exception>
    public double MeanAnomalyAt(double meanAnomalyAtEpoch, double secondsSinceEpoch)
    {
        double swept = RadiansPerSecond * secondsSinceEpoch;
        if (!double.IsFinite(swept))
        {
            throw new BadInputException(Invariant(
                $"The orbit can't be followed for {secondsSinceEpoch:R} s at {RadiansPerSecond:R} rad/s; "
                    + $"check the semi-major axis and the epoch."));
        }

        double sweptError = Math.FusedMultiplyAdd(RadiansPerSecond, secondsSinceEpoch, -swept);
        double reduced = AngleReduction.ToHalfTurn(swept, sweptError + (_correction * secondsSinceEpoch));
        return AngleReduction.ToHalfTurn(AngleReduction.ToHalfTurn(meanAnomalyAtEpoch) + reduced);
    }

    /// <summary>(mu - n^2 a^3) / mu, with the products carried to twice the digits of a double.</summary>
    private static double RelativeDefect(double n, double a)
    {
        const double mu = MoonConstants.GravitationalParameter;
        double nn = n * n;
        double nnError = Math.FusedMultiplyAdd(n, n, -nn);
        double aa = a * a;
        double aaError = Math.FusedMultiplyAdd(a, a, -aa);
        double aaa = aa * a;
        double aaaError = Math.FusedMultiplyAdd(aa, a, -aaa) + (aaError * a);
        double product = nn * aaa;
        double productError = Math.FusedMultiplyAdd(nn, aaa, -product) + (nn * aaaError) + (nnError * aaa);
        return (mu - product - productError) / mu;
    }
}
