using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;

namespace Msisf.Core.Camera;

/// <summary>
/// Where a camera is and how it points at each time: what a frame needs at its time, and a camera that scans at the time of each row. Safe
/// for several threads.
/// </summary>
public interface ICameraPath
{
    /// <summary>The times at which both are known.</summary>
    TdbCover Cover { get; }

    /// <summary>The camera at a time.</summary>
    /// <param name="tdbSeconds">TDB seconds past J2000; one step of a double is 6e-8 s.</param>
    /// <returns>Its place and orientation in MOON_ME of that time; its own seconds are 0.</returns>
    /// <exception cref="MsisfException">The time is outside the cover, which the message names, or the data are damaged.</exception>
    CameraState At(double tdbSeconds);
}
