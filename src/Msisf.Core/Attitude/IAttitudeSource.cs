using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Core.Attitude;

/// <summary>How a camera points along a trajectory: as a file says, or at a place, the nadir, ... Safe for several threads.</summary>
public interface IAttitudeSource
{
    /// <summary>The times at which it is known; all, unless data give it.</summary>
    TdbCover Cover => TdbCover.Everything;

    /// <summary>The orientation of the camera.</summary>
    /// <param name="point">Where the camera is, and how the Moon is turned there and then.</param>
    /// <returns>Turns camera axes (looks along -x, y right, z up) into axes of MOON_ME.</returns>
    /// <exception cref="MsisfException">The time is outside the cover, which the message names, or the data are damaged.</exception>
    UnitQuaternion MoonFromCamera(in TrajectoryPoint point);

    /// <summary>How fast the camera turns, where the source says it; null where that only follows from neighbouring attitudes.</summary>
    /// <exception cref="MsisfException">The time is outside the cover, or the data are damaged.</exception>
    TurnRate? RateOf(in TrajectoryPoint point) => null;
}

/// <summary>How fast a camera turns; <c>default</c> is not at all, along J2000's axes.</summary>
/// <param name="AboutCamera">rad/s about the camera's axes (looks along -x, y right, z up), right-handed.</param>
/// <param name="IsOverBody">Whether it is relative to the turning body; otherwise relative to J2000.</param>
public readonly record struct TurnRate(Vector3D AboutCamera, bool IsOverBody);

/// <summary>A spacecraft at one time of its trajectory; <c>default</c> is not a point.</summary>
/// <param name="Time">When.</param>
/// <param name="Tdb">The same time, as kernels count it.</param>
/// <param name="StateJ2000">Position (m) and velocity (m/s) relative to the body's centre, J2000.</param>
/// <param name="BodyFromJ2000">How the body is turned at the time.</param>
public readonly record struct TrajectoryPoint(
    Instant Time, TdbTime Tdb, StateVector StateJ2000, RotationMatrix BodyFromJ2000)
{
    /// <summary>m, body-fixed.</summary>
    public Vector3D PositionBodyFixed => BodyFromJ2000 * StateJ2000.Position;

    /// <summary>Direction of the orbit's angular momentum, body-fixed, any length.</summary>
    public Vector3D OrbitNormalBodyFixed => BodyFromJ2000 * Vector3D.Cross(StateJ2000.Position, StateJ2000.Velocity);
}
