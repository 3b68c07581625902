using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// All craters of a seed: placed uniformly and independently, with the density of highlands in equilibrium and a lower density on the
/// maria. They are generated cell by cell when a tile needs them; a crater is the same for every tile.
/// </summary>
/// <remarks>Their number: <see cref="CraterLaw"/>.</remarks>
internal sealed class CraterPopulation
{
    /// <summary>log2 of the freshness of the oldest craters; that of all is uniform up to 0.</summary>
    public const double OldestFreshnessLog2 = -5.0;

    private const ulong Purpose = 2;

    private readonly ulong _seed;
    private readonly MareMask _maria;
    private readonly double _smallest;
    private readonly double _largest;
    private readonly CraterLaw _law;
    private readonly CellMemory<PlacedCrater> _memory;

    /// <summary>The craters of a range of diameters.</summary>
    /// <param name="seed">The user's seed.</param>
    /// <param name="maria">Where the density is lower.</param>
    /// <param name="smallest">Minimum diameter, m, included.</param>
    /// <param name="largest">Maximum diameter, m, excluded.</param>
    /// <param name="law">Their number; null for that of synthetic models.</param>
    /// <param name="memory">Keeps those of the seed and the law that <see cref="PlacedNear"/> finds; null for an own one.</param>
    public CraterPopulation(
        ulong seed, MareMask maria, double smallest, double largest, CraterLaw? law = null, CellMemory<PlacedCrater>? memory = null)
    {
        _seed = seed;
        _maria = maria;
        _smallest = smallest;
        _largest = largest;
        _law = law ?? CraterLaw.OfModels;
        _memory = memory ?? new CellMemory<PlacedCrater>();
    }

    /// <summary>m: maximum diameter, excluded.</summary>
    public double Largest => _largest;

    /// <summary>log2 of m: the octaves of diameters, the smallest first.</summary>
    public IEnumerable<int> Octaves
    {
        get
        {
            for (int octave = (int)Math.Floor(PortableMath.Log2(_smallest)); Math.ScaleB(1.0, octave) < _largest; octave++)
            {
                yield return octave;
            }
        }
    }

    /// <summary>
    /// Every crater that may reach into a band of latitudes and longitudes, in an order that does not depend on the band.
    /// </summary>
    /// <param name="southDegrees">Southern border; below -90 for mirror lines.</param>
    /// <param name="northDegrees">Northern border; above 90 for mirror lines.</param>
    /// <param name="westDegrees">Western border.</param>
    /// <param name="widthDegrees">How far the band goes to the east.</param>
    public IEnumerable<Crater> Near(double southDegrees, double northDegrees, double westDegrees, double widthDegrees)
    {
        foreach ((int octave, CraterCell cell) in CellsNear(southDegrees, northDegrees, westDegrees, widthDegrees, ReachOfEjecta))
        {
            foreach (Crater crater in InCell(octave, cell))
            {
                if (2.0 * crater.Radius >= _smallest && 2.0 * crater.Radius < _largest)
                {
                    yield return crater;
                }
            }
        }
    }

    /// <summary>The same craters in the same order, with what follows from them; what was found is kept for the next time.</summary>
    /// <inheritdoc cref="Near"/>
    public IEnumerable<PlacedCrater> PlacedNear(double southDegrees, double northDegrees, double westDegrees, double widthDegrees)
    {
        foreach ((int octave, CraterCell cell) in CellsNear(southDegrees, northDegrees, westDegrees, widthDegrees, ReachOfEjecta))
        {
            foreach (PlacedCrater crater in _memory.Get(octave, cell, PlacedIn))
            {
                if (crater.Diameter >= _smallest && crater.Diameter < _largest)
                {
                    yield return crater;
                }
            }
        }
    }

    /// <summary>All craters of an octave of diameters in a cell, also those that are too small or too large.</summary>
    public PlacedCrater[] PlacedInCell(int octave, CraterCell cell) => _memory.Get(octave, cell, PlacedIn);

    /// <summary>The cells with a crater that may reach into a band of latitudes and longitudes.</summary>
    /// <param name="southDegrees">Southern border; below -90 for mirror lines.</param>
    /// <param name="northDegrees">Northern border; above 90 for mirror lines.</param>
    /// <param name="westDegrees">Western border.</param>
    /// <param name="widthDegrees">How far the band goes to the east.</param>
    /// <param name="reachOf">How far craters reach, in their radii, of a radius in m; the farther the larger they are.</param>
    public IEnumerable<(int Octave, CraterCell Cell)> CellsNear(
        double southDegrees, double northDegrees, double westDegrees, double widthDegrees, Func<double, double> reachOf)
    {
        foreach (int octave in Octaves)
        {
            double radius = Math.ScaleB(1.0, octave);
            double reach = reachOf(radius) * radius / MoonConstants.ReferenceRadius * (180.0 / Math.PI);
            foreach (CraterCell cell in new CraterCells(octave).Near(southDegrees, northDegrees, westDegrees, widthDegrees, reach))
            {
                yield return (octave, cell);
            }
        }
    }

    private static double ReachOfEjecta(double radius) => Crater.Reach;

    private IEnumerable<PlacedCrater> PlacedIn(int octave, CraterCell cell) =>
        InCell(octave, cell).Select(crater => new PlacedCrater(crater));

    /// <summary>All craters of an octave of diameters in a cell.</summary>
    private IEnumerable<Crater> InCell(int octave, CraterCell cell)
    {
        double min = Math.ScaleB(1.0, octave);
        SplitMix64 random = SplitMix64.For(_seed, Purpose + ((ulong)octave << 8), cell.Band, cell.Column);
        double none = PortableMath.Exp2(-_law.CountInOctave(octave) * cell.Area / 0.69314718055994530942);

        // Knuth: a Poisson count is the number of uniform numbers whose product is still above e^-mean.
        for (double product = random.NextUniform(); product > none; product *= random.NextUniform())
        {
            (double sinLatitude, double longitude) = cell.Place(random.NextUniform(), random.NextUniform());
            double diameter = min * _law.DiameterIn(min, random.NextUniform());
            double freshness = PortableMath.Exp2(OldestFreshnessLog2 * random.NextUniform());
            double kept = random.NextUniform();
            Crater crater = new(sinLatitude, longitude, 0.5 * diameter, freshness);
            if (kept < 1.0 - (MareFractionAt(crater) * (1.0 - _law.MareDensity(diameter))))
            {
                yield return crater;
            }
        }
    }

    /// <summary>Number of craters larger than one, per m2, in the ground around it.</summary>
    public double CountAbove(in PlacedCrater crater)
    {
        SelenographicPoint place = SelenographicPoint.Below(crater.Direction);
        double mare = _maria.At(double.RadiansToDegrees(place.Latitude), double.RadiansToDegrees(place.Longitude));
        return CountAbove(crater.Diameter, mare);
    }

    /// <summary>Number of craters larger than a diameter in m, per m2, in ground that is partly mare.</summary>
    public double CountAbove(double diameter, double mareFraction) =>
        _law.CountAbove(diameter) * (1.0 - (mareFraction * (1.0 - _law.MareDensity(diameter))));

    private double MareFractionAt(Crater crater) => _maria.At(crater.LatitudeDegrees, crater.LongitudeDegrees);
}
