using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.Core.Terrain;

namespace Msisf.Stress.Numerics;

/// <summary>The two-body motion that elements describe, in double-double; the elements are taken as exact.</summary>
internal sealed class WideOrbit
{
    private readonly DoubleDouble _axis;
    private readonly double _eccentricity;
    private readonly double _meanAnomalyAtEpoch;
    private readonly DoubleDouble _minorOverMajor;
    private readonly WideVector _towardsPeriapsis;
    private readonly WideVector _acrossPeriapsis;

    public WideOrbit(KeplerElements elements)
    {
        _axis = WideMath.Of(elements.SemiMajorAxis);
        _eccentricity = elements.Eccentricity;
        _meanAnomalyAtEpoch = elements.MeanAnomalyAtEpoch;
        DoubleDouble square = WideMath.Of(_eccentricity) * WideMath.Of(_eccentricity);
        _minorOverMajor = WideMath.SquareRoot(WideMath.Subtract(WideMath.Of(1.0), square));
        MeanMotion = WideMath.SquareRoot(WideMath.Divide(WideMath.Of(MoonConstants.GravitationalParameter), _axis * _axis * _axis));

        (DoubleDouble sinPeriapsis, DoubleDouble cosPeriapsis) = WideMath.SinCos(WideMath.Of(elements.ArgumentOfPeriapsis));
        (DoubleDouble sinNode, DoubleDouble cosNode) = WideMath.SinCos(WideMath.Of(elements.LongitudeOfAscendingNode));
        (DoubleDouble sinInclination, DoubleDouble cosInclination) = WideMath.SinCos(WideMath.Of(elements.Inclination));
        WideVector towardsNode = new(cosNode, sinNode, default);
        WideVector acrossNode = new(WideMath.Negate(sinNode) * cosInclination, cosNode * cosInclination, sinInclination);
        _towardsPeriapsis = (cosPeriapsis * towardsNode) + (sinPeriapsis * acrossNode);
        _acrossPeriapsis = (WideMath.Negate(sinPeriapsis) * towardsNode) + (cosPeriapsis * acrossNode);
    }

    /// <summary>rad/s.</summary>
    public DoubleDouble MeanMotion { get; }

    /// <summary>Towards the periapsis, as long as the eccentricity: defined for a circle too.</summary>
    public WideVector EccentricityVector => WideMath.Of(_eccentricity) * _towardsPeriapsis;

    /// <summary>Of the orbit's plane, length 1, the motion right-handed about it.</summary>
    public WideVector Normal => WideVector.Cross(_towardsPeriapsis, _acrossPeriapsis);

    /// <summary>M0 + n dt within half a turn of 0, rad.</summary>
    public DoubleDouble MeanAnomalyAt(DoubleDouble seconds) =>
        WideMath.ToHalfTurn(WideMath.Of(_meanAnomalyAtEpoch) + (MeanMotion * seconds));

    /// <summary>m and m/s.</summary>
    public (WideVector Position, WideVector Velocity) StateAt(DoubleDouble seconds)
    {
        DoubleDouble meanAnomaly = MeanAnomalyAt(seconds);
        double nearby = KeplerSolver.Solve(meanAnomaly.High, _eccentricity).Angle;
        DoubleDouble angle = WideKepler.Solve(nearby, _eccentricity, meanAnomaly);
        (DoubleDouble sin, DoubleDouble cos) = WideMath.SinCos(angle);
        WideVector position = (WideMath.Subtract(cos, WideMath.Of(_eccentricity)) * _towardsPeriapsis)
            + (_minorOverMajor * sin * _acrossPeriapsis);
        WideVector velocity = (WideMath.Negate(sin) * _towardsPeriapsis) + (_minorOverMajor * cos * _acrossPeriapsis);
        DoubleDouble speed = WideMath.Divide(_axis * MeanMotion, WideKepler.Slope(angle, _eccentricity));
        return (_axis * position, speed * velocity);
    }
}
