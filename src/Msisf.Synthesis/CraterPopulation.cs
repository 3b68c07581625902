using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// All craters of a seed: placed uniformly and independently, with the density of highlands in equilibrium and a lower density on the
/// maria. They are generated cell by cell when a tile needs them; a crater is the same for every tile.
/// </summary>
/// <remarks>
/// Equilibrium: N(&gt;D) = 0.079 D^-1.83 for each km2, D in km (N. J. Trask, JPL Tech. Rep. 32-800 (1966); it holds within a factor of 2 up
/// to tens of km on the highlands). Maria: the production of 3.5 Ga, about 3e-3 D^-3 (G. Neukum, B. A. Ivanov, W. K. Hartmann, Space Sci.
/// Rev. 96 (2001), 55), wherever that is below equilibrium, and not below 1/130 of it.
/// </remarks>
internal sealed class CraterPopulation
{
    private const ulong Purpose = 2;
    private const double Coefficient = 0.079; // per km2
    private const double Exponent = 1.83;
    private const double MareCoefficient = 3e-3; // per km2
    private const double MareExponent = 3.0;
    private const double MinMareDensity = 1.0 / 130.0;
    private const double OldestFreshnessLog2 = -5.0;

    private readonly ulong _seed;
    private readonly MareMask _maria;
    private readonly double _smallest;
    private readonly double _largest;

    /// <summary>The craters of a range of diameters.</summary>
    /// <param name="seed">The user's seed.</param>
    /// <param name="maria">Where the density is lower.</param>
    /// <param name="smallest">Minimum diameter, m, included.</param>
    /// <param name="largest">Maximum diameter, m, excluded.</param>
    public CraterPopulation(ulong seed, MareMask maria, double smallest, double largest)
    {
        _seed = seed;
        _maria = maria;
        _smallest = smallest;
        _largest = largest;
    }

    /// <summary>Number of craters larger than a diameter in m, per m2 of highlands.</summary>
    public static double HighlandsCountAbove(double diameter) => 1e-6 * Coefficient * PortableMath.Pow(1e-3 * diameter, -Exponent);

    /// <summary>Density of craters of a diameter in m on the maria, as a fraction of the density on highlands.</summary>
    public static double MareDensity(double diameter) => Math.Clamp(
        MareCoefficient / Coefficient * PortableMath.Pow(1e-3 * diameter, Exponent - MareExponent),
        MinMareDensity,
        1.0);

    /// <summary>
    /// Every crater that may reach into a band of latitudes and longitudes, in an order that does not depend on the band.
    /// </summary>
    /// <param name="southDegrees">Southern border; below -90 for mirror lines.</param>
    /// <param name="northDegrees">Northern border; above 90 for mirror lines.</param>
    /// <param name="westDegrees">Western border.</param>
    /// <param name="widthDegrees">How far the band goes to the east.</param>
    public IEnumerable<Crater> Near(double southDegrees, double northDegrees, double westDegrees, double widthDegrees)
    {
        for (int octave = (int)Math.Floor(PortableMath.Log2(_smallest)); Math.ScaleB(1.0, octave) < _largest; octave++)
        {
            double min = Math.ScaleB(1.0, octave);
            double density = HighlandsCountAbove(min) - HighlandsCountAbove(2.0 * min);
            double reach = Crater.Reach * min / MoonConstants.ReferenceRadius * (180.0 / Math.PI);
            foreach (CraterCell cell in new CraterCells(octave).Near(southDegrees, northDegrees, westDegrees, widthDegrees, reach))
            {
                foreach (Crater crater in InCell(cell, octave, density))
                {
                    yield return crater;
                }
            }
        }
    }

    private IEnumerable<Crater> InCell(CraterCell cell, int octave, double density)
    {
        double min = Math.ScaleB(1.0, octave);
        SplitMix64 random = SplitMix64.For(_seed, Purpose + ((ulong)octave << 8), cell.Band, cell.Column);
        double none = PortableMath.Exp2(-density * cell.Area / 0.69314718055994530942);

        // Knuth: a Poisson count is the number of uniform numbers whose product is still above e^-mean.
        for (double product = random.NextUniform(); product > none; product *= random.NextUniform())
        {
            (double sinLatitude, double longitude) = cell.Place(random.NextUniform(), random.NextUniform());
            double part = 1.0 - (random.NextUniform() * (1.0 - PortableMath.Exp2(-Exponent)));
            double diameter = min * PortableMath.Pow(part, -1.0 / Exponent);
            double freshness = PortableMath.Exp2(OldestFreshnessLog2 * random.NextUniform());
            double kept = random.NextUniform();
            Crater crater = new(sinLatitude, longitude, 0.5 * diameter, freshness);
            if (diameter >= _smallest && diameter < _largest && kept < 1.0 - (MareFractionAt(crater) * (1.0 - MareDensity(diameter))))
            {
                yield return crater;
            }
        }
    }

    private double MareFractionAt(Crater crater) => _maria.At(crater.LatitudeDegrees, crater.LongitudeDegrees);
}
