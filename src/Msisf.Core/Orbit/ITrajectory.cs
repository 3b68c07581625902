using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Core.Orbit;

/// <summary>Where a spacecraft is at each time of a trajectory: from kernels, or a file of states. Safe for several threads.</summary>
public interface ITrajectory
{
    /// <summary>The times at which its position is known.</summary>
    TdbCover Cover { get; }

    /// <summary>Position (m) and velocity (m/s) relative to the body's centre, along J2000's axes, which do not turn.</summary>
    /// <exception cref="MsisfException">The time is outside the cover, which the message names, or the data are damaged.</exception>
    StateVector StateJ2000(TdbTime time);
}
