namespace Msisf.Core.Surface;

/// <summary>
/// A point of the lattice of 2^-7 m on which every vertex of the Moon's surface lies; <c>default</c> is the Moon's centre.
/// </summary>
/// <param name="X">MOON_ME x in steps of 2^-7 m.</param>
/// <param name="Y">MOON_ME y in steps of 2^-7 m.</param>
/// <param name="Z">MOON_ME z in steps of 2^-7 m.</param>
public readonly record struct LatticePoint(int X, int Y, int Z)
{
    /// <summary>Lattice steps per metre.</summary>
    public const int StepsPerMetre = 128;

    /// <summary>m: radii must be below this, so that their number of steps stays below 2^30.</summary>
    public const double RadiusLimit = 1 << 23;

    /// <summary>Position, m, body-fixed.</summary>
    public Vector3D PositionBodyFixed => new((double)X / StepsPerMetre, (double)Y / StepsPerMetre, (double)Z / StepsPerMetre);

    /// <summary>The lattice point nearest to a point of the surface; the order of the products is part of the pattern format.</summary>
    /// <param name="radius">m, above 0 and below <see cref="RadiusLimit"/>.</param>
    public static LatticePoint Nearest(double radius, SineCosine latitude, SineCosine longitude)
    {
        double steps = StepsPerMetre * radius;
        double equatorial = steps * latitude.Cosine;
        return new LatticePoint(
            Round(equatorial * longitude.Cosine),
            Round(equatorial * longitude.Sine),
            Round(steps * latitude.Sine));
    }

    /// <summary>
    /// Rounds to the nearest whole number, half steps upwards also below zero: <c>floor(x + 0.5)</c>, which every programming language has.
    /// </summary>
    private static int Round(double steps) => (int)Math.Floor(steps + 0.5);
}
