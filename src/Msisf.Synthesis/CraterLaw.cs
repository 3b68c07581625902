namespace Msisf.Synthesis;

/// <summary>How many craters there are: the density of highlands in equilibrium, and a lower one on the maria.</summary>
/// <remarks>
/// Maria: the production of 3.2 Ga, about 3e-3 D^-3 for each km2, D in km (N(1 km) = 2.9e-3 by the chronology of G. Neukum, B. A. Ivanov,
/// W. K. Hartmann, Space Sci. Rev. 96 (2001), 55), wherever that is below equilibrium, and not below 1/130 of it.
/// </remarks>
internal sealed class CraterLaw
{
    private const double MareCoefficient = 3e-3; // per km2
    private const double MareExponent = 3.0;
    private const double MinMareDensity = 1.0 / 130.0;
    private const int LeastOctave = -8; // 4 mm
    private const int Octaves = 32;

    private readonly (double Coefficient, double Exponent) _small;
    private readonly (double Coefficient, double Exponent) _large;
    private readonly double _limit;
    private readonly double[] _inOctaves;

    private CraterLaw((double, double) small, (double, double) large, double limit)
    {
        (_small, _large, _limit) = (small, large, limit);
        _inOctaves = [.. Enumerable.Range(LeastOctave, Octaves).Select(octave =>
        {
            double min = Math.ScaleB(1.0, octave);
            return CountAbove(PieceOf(min), min) - CountAbove(PieceOf(min), 2.0 * min);
        })];
    }

    /// <summary>
    /// For synthetic models: N(&gt;D) = 0.079 D^-1.83 for each km2, D in km: Hartmann's law (<see cref="Published"/>) with 9 percent more
    /// craters. It stays, so that a model's options and seed give the same model as ever.
    /// </summary>
    public static CraterLaw OfModels { get; } = new((0.079, 1.83), (0.079, 1.83), double.PositiveInfinity);

    /// <summary>
    /// Equilibrium as it was published. Below 2048 m, near where the two meet: N(&gt;D) = 10^10.9 D^-2 for each 10^6 km2, D in m
    /// (N. J. Trask, in: Ranger VIII and IX, Part II, JPL Tech. Rep. 32-800 (1966)). Above: 10^-1.14 D^-1.83 for each km2, D in km
    /// (W. K. Hartmann, Icarus 60 (1984), 56).
    /// </summary>
    public static CraterLaw Published { get; } = new((0.0794328234724282, 2.0), (0.0724435960074990, 1.83), 2048.0);

    /// <summary>Number of craters of highlands larger than a diameter in m, per m2, of the law of that diameter.</summary>
    public double CountAbove(double diameter) => CountAbove(PieceOf(diameter), diameter);

    /// <summary>Number of craters of highlands from 2^octave m to twice that, per m2.</summary>
    public double CountInOctave(int octave) => _inOctaves[octave - LeastOctave];

    /// <summary>A diameter from one to two, so that craters of an octave follow the law.</summary>
    /// <param name="octave">Minimum diameter of the octave, m.</param>
    /// <param name="random">[0, 1), uniform.</param>
    public double DiameterIn(double octave, double random)
    {
        double exponent = PieceOf(octave).Exponent;
        double part = 1.0 - (random * (1.0 - PortableMath.Exp2(-exponent)));
        return PortableMath.Pow(part, -1.0 / exponent);
    }

    /// <summary>Density of craters of a diameter in m on the maria, as a fraction of the density on highlands.</summary>
    public double MareDensity(double diameter)
    {
        (double coefficient, double exponent) = PieceOf(diameter);
        return Math.Clamp(
            MareCoefficient / coefficient * PortableMath.Pow(1e-3 * diameter, exponent - MareExponent), MinMareDensity, 1.0);
    }

    private static double CountAbove((double Coefficient, double Exponent) piece, double diameter) =>
        1e-6 * piece.Coefficient * PortableMath.Pow(1e-3 * diameter, -piece.Exponent);

    private (double Coefficient, double Exponent) PieceOf(double diameter) => diameter < _limit ? _small : _large;
}
