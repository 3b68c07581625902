namespace Msisf.Core.Orbit;

/// <summary>The frame in which elements or state vectors are given, and which the orbit keeps (docs/deviations.md, row 22).</summary>
public enum OrbitFrame
{
    /// <summary>MOON_ME as if it did not turn: the thesis's way and the default. It turns by 13.18 degrees a day.</summary>
    MoonMe,

    /// <summary>The MOON_ME axes of the epoch, held inertial.</summary>
    MoonMeEpoch,

    /// <summary>J2000 (ICRF) axes with the Moon in the origin.</summary>
    J2000,
}
