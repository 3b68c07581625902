namespace Msisf.Core.Terrain;

/// <summary>Constants of the Moon, each with its source.</summary>
public static class MoonConstants
{
    /// <summary>
    /// m: LOLA's reference radius; heights are measured from it, and the pixels' rays are intersected with it (D. E. Smith et al.,
    /// LRO-L-LOLA-4-GDR-V1.0; docs/deviations.md, row 8).
    /// </summary>
    public const double ReferenceRadius = 1_737_400.0;

    /// <summary>
    /// m: how far the surface may be from the reference radius. The Moon's relief is from -9.2 to +10.8 km; the pattern files hold no
    /// more than this either (docs/pattern-format.md, section 4).
    /// </summary>
    public const double MaxRelief = 20_000.0;

    /// <summary>m: how far the surface of another body may be from the sphere of its heights; Mars's is 29 km.</summary>
    private const double MaxReliefOfOthers = 30_000.0;

    /// <summary>m: how far a surface may be from the sphere of its heights.</summary>
    /// <param name="referenceRadius">Radius of the sphere, m.</param>
    public static double MaxReliefOver(double referenceRadius) =>
        referenceRadius == ReferenceRadius ? MaxRelief : MaxReliefOfOthers;

    /// <summary>
    /// m over the reference radius: heights beyond these are none. The Moon's ground lies from -9.2 to +10.8 km, with its steepest steps
    /// (D. E. Smith et al., Icarus 283 (2017) 70); fill values such as -9999 and -32768 lie beyond.
    /// </summary>
    public static (double Min, double Max) PlausibleHeights => (-9_500.0, 11_500.0);

    /// <summary>m: mean radius MMR, for the flight altitude only (thesis, list of constants).</summary>
    public const double MeanRadius = 1_737_150.0;

    /// <summary>
    /// rad/s: rate at which the Moon turns in space, 13.17635815 degrees a day (B. A. Archinal et al., Celest. Mech. Dyn. Astr. 130 (2018)
    /// 22, table 2: W of the Moon). For notes only; the ephemeris has the exact rotation.
    /// </summary>
    public const double RotationRate = 2.661699458e-6;

    /// <summary>m3/s2: standard gravitational parameter (thesis section 6.2.2).</summary>
    public const double GravitationalParameter = 4.902801076e12;
}
