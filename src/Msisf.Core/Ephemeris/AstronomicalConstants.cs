namespace Msisf.Core.Ephemeris;

/// <summary>Sizes in the solar system, each with its source.</summary>
public static class AstronomicalConstants
{
    /// <summary>m, exact by definition (IAU 2012 Resolution B2).</summary>
    public const double AstronomicalUnit = 149_597_870_700.0;

    /// <summary>m: nominal solar radius, exact by definition (IAU 2015 Resolution B3; A. Prsa et al., Astron. J. 152 (2016) 41).</summary>
    public const double SunRadius = 695_700e3;

    /// <summary>m: mean radius of the Earth (B. A. Archinal et al., Celest. Mech. Dyn. Astr. 130 (2018) 22, table 4).</summary>
    public const double EarthRadius = 6_371_008.4;

    /// <summary>s, exact by definition: 365.25 days.</summary>
    public const double JulianYear = 31_557_600.0;
}
