namespace Msisf.Core.Orbit;

/// <summary>
/// The frame in which elements or state vectors are given and in which the orbit is propagated (docs/deviations.md, row 22).
/// </summary>
public enum OrbitFrame
{
    /// <summary>
    /// MOON_ME treated as if it did not rotate (as in the thesis; the default), although it rotates by 13.18 degrees a day.
    /// </summary>
    MoonMe,

    /// <summary>The MOON_ME axes of the epoch, held inertial.</summary>
    MoonMeEpoch,

    /// <summary>J2000 (ICRF) axes with the Moon in the origin.</summary>
    J2000,
}
