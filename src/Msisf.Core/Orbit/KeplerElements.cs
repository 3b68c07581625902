namespace Msisf.Core.Orbit;

/// <summary>An elliptic orbit about the Moon's centre; <c>default</c> is not an orbit and is refused where it is used.</summary>
/// <remarks>
/// Where an angle is undefined, the usual convention holds: the node is the x axis if the inclination is 0 or pi, the periapsis is the
/// node if the eccentricity is 0 (docs/deviations.md, row 3).
/// </remarks>
public readonly record struct KeplerElements
{
    /// <summary>
    /// Checks the elements. Angles may have any finite value; full turns, and an inclination outside [0, pi], are applied as rotations.
    /// </summary>
    /// <param name="semiMajorAxis">a, m, above 0.</param>
    /// <param name="eccentricity">e, 0 &lt;= e &lt; 1.</param>
    /// <param name="argumentOfPeriapsis">omega, rad.</param>
    /// <param name="longitudeOfAscendingNode">Omega, rad.</param>
    /// <param name="inclination">i, rad.</param>
    /// <param name="meanAnomalyAtEpoch">M0, rad.</param>
    /// <exception cref="BadInputException">An element is not finite or out of its range.</exception>
    public KeplerElements(
        double semiMajorAxis,
        double eccentricity,
        double argumentOfPeriapsis,
        double longitudeOfAscendingNode,
        double inclination,
        double meanAnomalyAtEpoch)
    {
        SemiMajorAxis = Guard.Finite(semiMajorAxis, "The semi-major axis a (m)");
        Eccentricity = Guard.Finite(eccentricity, "The eccentricity e");
        ArgumentOfPeriapsis = Guard.Finite(argumentOfPeriapsis, "The argument of periapsis omega (rad)");
        LongitudeOfAscendingNode = Guard.Finite(longitudeOfAscendingNode, "The longitude of the ascending node Omega (rad)");
        Inclination = Guard.Finite(inclination, "The inclination i (rad)");
        MeanAnomalyAtEpoch = Guard.Finite(meanAnomalyAtEpoch, "The mean anomaly at epoch M0 (rad)");

        if (semiMajorAxis <= 0.0)
        {
            throw Refused($"The semi-major axis a is {semiMajorAxis:R} m; an elliptic orbit needs one above 0 m.");
        }

        if (eccentricity < 0.0)
        {
            throw Refused($"The eccentricity e is {eccentricity:R}; it can't be below 0.");
        }

        if (eccentricity >= 1.0)
        {
            throw Refused(
                $"The eccentricity e is {eccentricity:R}, a parabola or hyperbola; only elliptic orbits, 0 <= e < 1, can be followed.");
        }
    }

    /// <summary>a, m.</summary>
    public double SemiMajorAxis { get; }

    /// <summary>e.</summary>
    public double Eccentricity { get; }

    /// <summary>omega, rad, from the ascending node.</summary>
    public double ArgumentOfPeriapsis { get; }

    /// <summary>Omega, rad, from the x axis of the orbit's frame.</summary>
    public double LongitudeOfAscendingNode { get; }

    /// <summary>i, rad, over the xy plane of the orbit's frame.</summary>
    public double Inclination { get; }

    /// <summary>M0, rad.</summary>
    public double MeanAnomalyAtEpoch { get; }

    /// <summary>Minimum distance from the Moon's centre, m: a (1 - e).</summary>
    public double PeriapsisRadius => SemiMajorAxis * (1.0 - Eccentricity);

    private static BadInputException Refused(FormattableString message) => new(message.ToString(CultureInfo.InvariantCulture));
}
