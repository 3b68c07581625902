namespace Msisf.TestSupport;

/// <summary>
/// Bounds of asserts that only rounding may use up. Each lies above what rounding leaves on numbers of its kind, as the number of ulps
/// says, and far below what a wrong formula, sign, unit or half a pixel would make.
/// </summary>
internal static class Rounding
{
    /// <summary>4 ulps of 1: unit vectors, fractions and angles in rad after a few operations.</summary>
    public const double OfUnits = 1e-15;

    /// <summary>45 ulps of 1: unit vectors, rotations and ratios after several turns, or after some dozen operations.</summary>
    public const double OfTurns = 1e-14;

    /// <summary>4,500 ulps of 1, 18 of 360 degrees: sums over many terms, solved equations, degrees from rad and back.</summary>
    public const double OfChains = 1e-12;

    /// <summary>Pixels and degrees of up to 1,000, which have 900 ulps of it, after a system of equations.</summary>
    public const double OfSolutions = 1e-10;

    /// <summary>4 ulps of a place 2e6 m from the body's centre, thousands of a pixel or of a degree; text of ten digits too.</summary>
    public const double OfPlaces = 1e-9;

    /// <summary>43 ulps of a place 2e6 m from the body's centre: places after several conversions, or two lengths compared.</summary>
    public const double OfConvertedPlaces = 1e-8;
}
