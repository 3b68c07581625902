namespace Msisf.Core.Sky;

/// <summary>A star of a catalogue. <c>default</c> has no direction and is not a star.</summary>
/// <param name="Identity">The catalogue's name of it, e.g. "HIP 32349"; no two are the same.</param>
/// <param name="Direction">Length 1, ICRS, at <paramref name="EpochYears"/>.</param>
/// <param name="ProperMotion">rad per Julian year, ICRS, perpendicular to the direction.</param>
/// <param name="Parallax">rad; 0 where it is not known.</param>
/// <param name="EpochYears">Julian years after J2000 at which it was there: -8.75 for Hipparcos.</param>
/// <param name="Magnitude">V of Johnson.</param>
/// <param name="Colour">B - V of Johnson; null where it is not known.</param>
public readonly record struct Star(
    string Identity, Vector3D Direction, Vector3D ProperMotion, double Parallax, double EpochYears, double Magnitude, double? Colour)
{
    /// <summary>Milliarcseconds in a radian.</summary>
    private const double MasPerRadian = 648_000_000.0 / Math.PI;

    /// <summary>Makes a star of the numbers of a catalogue.</summary>
    /// <param name="identity">The catalogue's name of it.</param>
    /// <param name="degrees">Right ascension and declination in degrees, ICRS, at the epoch.</param>
    /// <param name="motionMas">mas a year: proper motion of right ascension, times the declination's cosine; of declination.</param>
    /// <param name="parallaxMas">mas; 0 where it is not known. Measured ones may be negative.</param>
    /// <param name="epochYears">Julian years after J2000.</param>
    /// <param name="magnitude">V.</param>
    /// <param name="colour">B - V; null where it is not known.</param>
    public static Star FromCatalogue(
        string identity, (double RightAscension, double Declination) degrees, (double East, double North) motionMas, double parallaxMas,
        double epochYears, double magnitude, double? colour)
    {
        (double sinRa, double cosRa) = Trigonometry.SinCos(double.DegreesToRadians(degrees.RightAscension));
        (double sinDec, double cosDec) = Trigonometry.SinCos(double.DegreesToRadians(degrees.Declination));
        Vector3D east = new(-sinRa, cosRa, 0.0);
        Vector3D north = new(-sinDec * cosRa, -sinDec * sinRa, cosDec);
        return new Star(
            identity,
            new Vector3D(cosDec * cosRa, cosDec * sinRa, sinDec),
            ((motionMas.East * east) + (motionMas.North * north)) / MasPerRadian,
            Math.Max(0.0, parallaxMas) / MasPerRadian,
            epochYears,
            magnitude,
            colour);
    }

    /// <summary>The direction from an observer at rest, length 1, ICRS.</summary>
    /// <param name="yearsPastJ2000">Julian years.</param>
    /// <param name="observerAu">Where the observer is, from the solar system's barycentre, au, ICRS.</param>
    /// <remarks>
    /// The star moves on a straight line across the sky; its radial velocity, which matters below 1 mas in a century for all but a few
    /// stars, is left out.
    /// </remarks>
    public Vector3D DirectionFrom(double yearsPastJ2000, Vector3D observerAu) =>
        (Direction + ((yearsPastJ2000 - EpochYears) * ProperMotion) - (Parallax * observerAu)).Normalized();
}
