using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>Where the Sun is and how the Moon's ME/PA frame is turned; the port that the ephemeris engines fill. Safe for several threads.</summary>
public interface IEphemeris
{
    /// <summary>Name and version of the engine for the run's log, e.g. "CSPICE N0067".</summary>
    string EngineName { get; }

    /// <summary>Geometric position of the Sun relative to the Moon's centre, without light time or aberration.</summary>
    /// <param name="time">UTC.</param>
    /// <returns>m, MOON_ME.</returns>
    /// <exception cref="SpiceException">The time is outside the kernels' cover, which the message names.</exception>
    Vector3D SunPositionMoonMe(ModifiedJulianDate time);

    /// <summary>The rotation that turns J2000 components into MOON_ME components.</summary>
    /// <param name="time">UTC.</param>
    /// <exception cref="SpiceException">The time is outside the kernels' cover, which the message names.</exception>
    RotationMatrix MoonMeFromJ2000(ModifiedJulianDate time);
}
