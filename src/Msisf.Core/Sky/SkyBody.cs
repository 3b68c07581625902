namespace Msisf.Core.Sky;

/// <summary>A planet, the Earth or the Sun behind the ground. Immutable.</summary>
/// <param name="Name">English name.</param>
/// <param name="NaifNumber">NAIF's number of what the kernels have: for planets other than the Earth the barycentre.</param>
/// <param name="EquatorialRadius">m.</param>
/// <param name="PolarRadius">m.</param>
/// <param name="PoleDegrees">Right ascension and declination of the north pole at J2000, degrees.</param>
/// <remarks>
/// Radii and poles: B. A. Archinal et al., Celest. Mech. Dyn. Astr. 130 (2018) 22, tables 1 and 4; the Sun: IAU 2015 Resolution B3.
/// Precession turns the Earth's pole by 0.56 degrees in a century, which moves its outline by 3e-5 of the radius.
/// </remarks>
public sealed record SkyBody(
    string Name, int NaifNumber, double EquatorialRadius, double PolarRadius, (double RightAscension, double Declination) PoleDegrees)
{
    /// <summary>The Sun.</summary>
    public static SkyBody Sun { get; } = new(
        "Sun", 10, Ephemeris.AstronomicalConstants.SunRadius, Ephemeris.AstronomicalConstants.SunRadius, (286.13, 63.87));

    /// <summary>The Earth.</summary>
    public static SkyBody Earth { get; } = new("Earth", 399, 6_378_136.6, 6_356_751.9, (0.0, 90.0));

    /// <summary>The planets but the Earth, from Mercury to Neptune.</summary>
    public static IReadOnlyList<SkyBody> Planets { get; } =
    [
        new("Mercury", 1, 2_440_530.0, 2_438_260.0, (281.0103, 61.4155)), new("Venus", 2, 6_051_800.0, 6_051_800.0, (272.76, 67.16)),
        new("Mars", 4, 3_396_190.0, 3_376_200.0, (317.681, 52.886)), new("Jupiter", 5, 71_492_000.0, 66_854_000.0, (268.057, 64.495)),
        new("Saturn", 6, 60_268_000.0, 54_364_000.0, (40.589, 83.537)), new("Uranus", 7, 25_559_000.0, 24_973_000.0, (257.311, -15.175)),
        new("Neptune", 8, 24_764_000.0, 24_341_000.0, (299.36, 43.46)),
    ];

    /// <summary>The north pole, length 1, J2000.</summary>
    public Vector3D PoleJ2000
    {
        get
        {
            (double sinRa, double cosRa) = Trigonometry.SinCos(double.DegreesToRadians(PoleDegrees.RightAscension));
            (double sinDec, double cosDec) = Trigonometry.SinCos(double.DegreesToRadians(PoleDegrees.Declination));
            return new Vector3D(cosDec * cosRa, cosDec * sinRa, sinDec);
        }
    }
}
