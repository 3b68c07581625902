namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Where the quantities of <see cref="HapkeLanes"/> lie in its buffer, a block of vectors each; a later one takes the place of one that is
/// no longer needed.
/// </summary>
internal static class HapkePlaces
{
    /// <summary>Vectors of a block: with its buffer it stays in the fastest memory.</summary>
    public const int Block = 8;

    /// <summary>Vectors of the buffer.</summary>
    public const int Length = 13 * Block;

    /// <summary>
    /// First of the numbers whose inverse roots are needed: sin^2 of incidence and emission, the lobes, a quarter of sin^2 g.
    /// </summary>
    public const int Roots = 0;

    /// <summary>How many blocks <see cref="Roots"/> are.</summary>
    public const int RootBlocks = 5;

    /// <summary>First of the exponents.</summary>
    public const int Exponents = 5 * Block;

    /// <summary>How many blocks <see cref="Exponents"/> are.</summary>
    public const int ExponentBlocks = 5;

    /// <summary>1 / sin of the incidence angle.</summary>
    public const int PerSunSine = Roots;

    /// <summary>1 / sin of the emission angle.</summary>
    public const int PerViewerSine = Roots + Block;

    /// <summary>The backward lobe; then the numerator of single scattering.</summary>
    public const int Backward = Roots + (2 * Block);

    /// <summary>The forward lobe; then the denominator of single scattering.</summary>
    public const int Forward = Roots + (3 * Block);

    /// <summary>2 / sin of the phase angle; then the haversine of the azimuth.</summary>
    public const int PerPhaseSine = Roots + (4 * Block);

    /// <summary>Numerator of single scattering.</summary>
    public const int Single = Backward;

    /// <summary>Denominator of single scattering.</summary>
    public const int PerSingle = Forward;

    /// <summary>The haversine of the azimuth; in the end the effective cosine of the lower direction.</summary>
    public const int Azimuth = PerPhaseSine;

    /// <summary>Sine of the direction nearer to the horizon; in the end the effective cosine of the upper one.</summary>
    public const int LowerSine = PerSunSine;

    /// <summary>Sine of the direction nearer to the zenith; in the end the light that is not in shadow.</summary>
    public const int UpperSine = PerViewerSine;

    /// <summary>E1 - 1 of the lower direction.</summary>
    public const int LowerE1 = Exponents;

    /// <summary>E2 - 1 of the lower direction.</summary>
    public const int LowerE2 = Exponents + Block;

    /// <summary>E1 - 1 of the upper direction.</summary>
    public const int UpperE1 = Exponents + (2 * Block);

    /// <summary>E2 - 1 of the upper direction.</summary>
    public const int UpperE2 = Exponents + (3 * Block);

    /// <summary>f(psi) - 1.</summary>
    public const int Hidden = Exponents + (4 * Block);

    /// <summary>The azimuth, of a half turn; before, what it is to be multiplied by.</summary>
    public const int AzimuthOverPi = 10 * Block;

    /// <summary>The azimuth from the other side, of a half turn.</summary>
    public const int AzimuthFromBehind = 11 * Block;

    /// <summary>Effective cosine of the lower direction.</summary>
    public const int Lower = Azimuth;

    /// <summary>Effective cosine of the upper direction.</summary>
    public const int Upper = LowerSine;

    /// <summary>The denominator of the shadowing.</summary>
    public const int Shadowed = UpperSine;

    /// <summary>The exponent of 2 in the lower direction's logarithm.</summary>
    public const int LowerExponent = LowerE1;

    /// <summary>The exponent of 2 in the upper direction's logarithm.</summary>
    public const int UpperExponent = LowerE2;

    /// <summary>The rest of the lower direction's logarithm.</summary>
    public const int LowerRest = UpperE1;

    /// <summary>The rest of the upper direction's logarithm.</summary>
    public const int UpperRest = UpperE2;

    /// <summary>The product of the inverses of both H.</summary>
    public const int Absorbed = 12 * Block;
}
