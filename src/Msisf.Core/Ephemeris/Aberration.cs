namespace Msisf.Core.Ephemeris;

/// <summary>Which effects of light's finite speed the Sun's position includes; the values are those of SPICE.</summary>
public enum Aberration
{
    /// <summary>None: where the Sun is at the time (SPICE "NONE"; the thesis).</summary>
    None,

    /// <summary>Light time: where the Sun was when it sent the light that arrives at the time (SPICE "LT", one iteration).</summary>
    LightTime,

    /// <summary>Light time, and the direction from which the moving Moon sees the light come (SPICE "LT+S").</summary>
    LightTimeAndStellar,
}
