using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Time;

namespace Msisf.Core.Attitude;

/// <summary>A spacecraft at one time of its trajectory; <c>default</c> is no point.</summary>
/// <param name="TdbSeconds">TDB seconds past J2000.</param>
/// <param name="Time">The same time, UTC; rounded to 0.6 microseconds.</param>
/// <param name="StateJ2000">Position (m) and velocity (m/s) relative to the body's centre, J2000.</param>
/// <param name="MoonMeFromJ2000">How the Moon is turned at the time.</param>
public readonly record struct TrajectoryPoint(
    double TdbSeconds, ModifiedJulianDate Time, StateVector StateJ2000, RotationMatrix MoonMeFromJ2000)
{
    /// <summary>m, MOON_ME.</summary>
    public Vector3D PositionMoonMe => MoonMeFromJ2000 * StateJ2000.Position;

    /// <summary>Direction of the orbit's angular momentum, MOON_ME, any length.</summary>
    public Vector3D OrbitNormalMoonMe => MoonMeFromJ2000 * Vector3D.Cross(StateJ2000.Position, StateJ2000.Velocity);
}
