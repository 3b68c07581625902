using Msisf.Core.Ephemeris;

namespace Msisf.Core.Orbit;

/// <summary>
/// The unperturbed two-body motion that elements describe, in the frame in which they are given. Immutable, safe for several threads.
/// </summary>
/// <remarks>Thesis eq. 6.1-6.9; the y rows of eq. 6.8 and 6.9 are corrected (docs/deviations.md, row 1).</remarks>
public sealed class KeplerOrbit
{
    private readonly MeanMotion _meanMotion;
    private readonly Vector3D _towardsPeriapsis;
    private readonly Vector3D _acrossPeriapsis;

    /// <summary>Prepares the orbit.</summary>
    /// <param name="elements">The orbit at its epoch.</param>
    /// <exception cref="ArgumentException"><paramref name="elements"/> is <c>default</c>.</exception>
    public KeplerOrbit(KeplerElements elements)
    {
        if (elements == default)
        {
            throw new ArgumentException("No orbit: the elements were never set.", nameof(elements));
        }

        Elements = elements;
        _meanMotion = new MeanMotion(elements.SemiMajorAxis);

        (double sinPeriapsis, double cosPeriapsis) = Trigonometry.SinCos(elements.ArgumentOfPeriapsis);
        (double sinNode, double cosNode) = Trigonometry.SinCos(elements.LongitudeOfAscendingNode);
        (double sinInclination, double cosInclination) = Trigonometry.SinCos(elements.Inclination);
        _towardsPeriapsis = new Vector3D(
            (cosPeriapsis * cosNode) - (sinPeriapsis * cosInclination * sinNode),
            (cosPeriapsis * sinNode) + (sinPeriapsis * cosInclination * cosNode),
            sinPeriapsis * sinInclination);
        _acrossPeriapsis = new Vector3D(
            (-sinPeriapsis * cosNode) - (cosPeriapsis * cosInclination * sinNode),
            (-sinPeriapsis * sinNode) + (cosPeriapsis * cosInclination * cosNode),
            cosPeriapsis * sinInclination);
    }

    /// <summary>The orbit at its epoch.</summary>
    public KeplerElements Elements { get; }

    /// <summary>Direction of the angular momentum, length 1.</summary>
    public Vector3D Normal => Vector3D.Cross(_towardsPeriapsis, _acrossPeriapsis);

    /// <summary>Position in m.</summary>
    /// <param name="secondsSinceEpoch">SI seconds, finite, may be negative.</param>
    /// <exception cref="Errors.BadInputException">The time is too far from the epoch to be counted in radians.</exception>
    public Vector3D PositionAt(double secondsSinceEpoch) => Position(AnomalyAt(secondsSinceEpoch));

    /// <summary>Position and velocity.</summary>
    /// <param name="secondsSinceEpoch">SI seconds, finite, may be negative.</param>
    /// <exception cref="Errors.BadInputException">The time is too far from the epoch to be counted in radians.</exception>
    public StateVector StateAt(double secondsSinceEpoch)
    {
        EccentricAnomaly anomaly = AnomalyAt(secondsSinceEpoch);
        double speed = Elements.SemiMajorAxis * _meanMotion.RadiansPerSecond;
        Vector3D velocity = speed * ((anomaly.VelocityX * _towardsPeriapsis) + (anomaly.VelocityY * _acrossPeriapsis));
        return new StateVector(Position(anomaly), velocity);
    }

    private EccentricAnomaly AnomalyAt(double secondsSinceEpoch) => KeplerSolver.Solve(
        _meanMotion.MeanAnomalyAt(Elements.MeanAnomalyAtEpoch, secondsSinceEpoch),
        Elements.Eccentricity);

    private Vector3D Position(EccentricAnomaly anomaly) =>
        Elements.SemiMajorAxis * ((anomaly.X * _towardsPeriapsis) + (anomaly.Y * _acrossPeriapsis));
}
