using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;

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
}
