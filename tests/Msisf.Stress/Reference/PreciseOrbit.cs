using Msisf.Core.Orbit;
using Msisf.Core.Terrain;

namespace Msisf.Stress.Reference;

/// <summary>The two-body motion that elements describe, to some 30 digits; the elements are taken as exact.</summary>
internal sealed class PreciseOrbit
{
    private readonly DoubleWord _axis;
    private readonly double _eccentricity;
    private readonly double _meanAnomalyAtEpoch;
    private readonly DoubleWord _minorOverMajor;
    private readonly PreciseVector _towardsPeriapsis;
    private readonly PreciseVector _acrossPeriapsis;

    public PreciseOrbit(KeplerElements elements)
    {
        _axis = elements.SemiMajorAxis;
        _eccentricity = elements.Eccentricity;
        _meanAnomalyAtEpoch = elements.MeanAnomalyAtEpoch;
        _minorOverMajor = DoubleWord.Sqrt(1.0 - ((DoubleWord)_eccentricity * _eccentricity));
        MeanMotion = DoubleWord.Sqrt(MoonConstants.GravitationalParameter / (_axis * _axis * _axis));

        (DoubleWord sinPeriapsis, DoubleWord cosPeriapsis) = PreciseMath.SinCos(elements.ArgumentOfPeriapsis);
        (DoubleWord sinNode, DoubleWord cosNode) = PreciseMath.SinCos(elements.LongitudeOfAscendingNode);
        (DoubleWord sinInclination, DoubleWord cosInclination) = PreciseMath.SinCos(elements.Inclination);
        PreciseVector towardsNode = new(cosNode, sinNode, default);
        PreciseVector acrossNode = new(-sinNode * cosInclination, cosNode * cosInclination, sinInclination);
        _towardsPeriapsis = (cosPeriapsis * towardsNode) + (sinPeriapsis * acrossNode);
        _acrossPeriapsis = (cosPeriapsis * acrossNode) - (sinPeriapsis * towardsNode);
    }

    /// <summary>rad/s.</summary>
    public DoubleWord MeanMotion { get; }

    /// <summary>Towards the periapsis, as long as the eccentricity: defined for a circle too.</summary>
    public PreciseVector EccentricityVector => _eccentricity * _towardsPeriapsis;

    /// <summary>Of the orbit's plane, length 1, the motion right-handed about it.</summary>
    public PreciseVector Normal => PreciseVector.Cross(_towardsPeriapsis, _acrossPeriapsis);

    /// <summary>M0 + n dt within half a turn of 0, rad.</summary>
    public DoubleWord MeanAnomalyAt(DoubleWord seconds) => PreciseMath.ToHalfTurn(_meanAnomalyAtEpoch + (MeanMotion * seconds));

    /// <summary>m and m/s.</summary>
    public (PreciseVector Position, PreciseVector Velocity) StateAt(DoubleWord seconds)
    {
        DoubleWord meanAnomaly = MeanAnomalyAt(seconds);
        double nearby = KeplerSolver.Solve(meanAnomaly.High, _eccentricity).Angle;
        DoubleWord angle = PreciseKepler.Solve(nearby, _eccentricity, meanAnomaly);
        (DoubleWord sin, DoubleWord cos) = PreciseMath.SinCos(angle);
        PreciseVector position = ((cos - _eccentricity) * _towardsPeriapsis) + (_minorOverMajor * sin * _acrossPeriapsis);
        PreciseVector velocity = (_minorOverMajor * cos * _acrossPeriapsis) - (sin * _towardsPeriapsis);
        DoubleWord speed = _axis * MeanMotion / PreciseKepler.Slope(angle, _eccentricity);
        return (_axis * position, speed * velocity);
    }
}
