using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// All boulders of a seed: some placed uniformly and independently, some around fresh craters. A boulder is the same for every block of
/// ground.
/// </summary>
/// <remarks>
/// Number: N(&gt;D) = 5e5 D^-2.11 for each 100 m2, D in mm, at Surveyor 1's site (E. M. Shoemaker, E. C. Morris, Icarus 12 (1970), 188).
/// Larger blocks are rarer than that (M. J. Cintala, K. M. McBride, NASA TM 104804 (1995)), so there is none above 4 m. Height: 0.3 to 0.9
/// of the length, 0.6 in the mean (N. E. Demidov, A. T. Basilevsky, Sol. Syst. Res. 48 (2014), 324). Half of the boulders from 25 cm on lie
/// around fresh craters that can have thrown them: the largest block of a crater of diameter D is 0.3 D^(2/3), in m (H. J. Moore, in:
/// Interagency Report Astrogeology 30 (1971); G. D. Bart, H. J. Melosh, Geophys. Res. Lett. 34 (2007), L07203), and as many lie in a place
/// as there is ejecta, which falls with the third power of the distance (T. R. McGetchin et al., EPSL 20 (1973), 226). So the number over
/// an area stays that of the law.
/// </remarks>
/// <param name="seed">The user's seed.</param>
/// <param name="smallest">m: minimum length, a power of two.</param>
/// <param name="craters">The craters of the ground.</param>
/// <param name="memory">Keeps those of the seed that were found.</param>
internal sealed class BoulderPopulation(ulong seed, double smallest, CraterPopulation craters, CellMemory<Boulder> memory)
{
    private const ulong Purpose = 7;
    private const double CountAboveOneMillimetre = 5e5 / 100.0; // per m2
    private const double Exponent = 2.11;
    private const double Largest = 4.0; // m
    private const double LeastWidth = 0.6; // lengths
    private const double LeastHeight = 0.3; // lengths
    private const double HighestHeight = 0.9;

    /// <summary>Part of the boulders of an octave that lies around craters.</summary>
    private const double PartAroundCraters = 0.5;

    /// <summary>log2 of m: smaller ones lie everywhere.</summary>
    private const int LeastOctaveAroundCraters = -2;

    /// <summary>Octaves of diameters of the craters that have boulders of one octave around them.</summary>
    private const int CraterOctaves = 3;

    /// <summary>Freshness from which on a crater has its blocks: a fifth of all craters.</summary>
    private const double FreshFrom = 0.5;

    /// <summary>Sum of D^2 of the fresh craters of an octave over an area, in equilibrium: 0.2 x 0.0794 x 2 ln 2.</summary>
    private const double FreshCover = 0.0220;

    // Radii from the crater's centre between which its blocks lie.
    private const double Innermost = 0.9;
    private const double Outermost = Crater.Reach;

    /// <summary>
    /// Boulders a radius from a crater's centre, in those of the law over the same area. An integral from the innermost to the outermost
    /// place makes <see cref="PartAroundCraters"/> of it.
    /// </summary>
    private const double AtRim = PartAroundCraters / (CraterOctaves * FreshCover) * 2.0
        / (Math.PI * ((1.0 / Innermost) - (1.0 / Outermost)));

    /// <summary>Number of boulders longer than a length in m, per m2.</summary>
    public static double CountAbove(double length) => CountAboveOneMillimetre * PortableMath.Pow(1000.0 * length, -Exponent);

    /// <summary>
    /// Every boulder that may reach into a band of latitudes and longitudes, in an order that does not depend on the band.
    /// </summary>
    /// <param name="southDegrees">Southern border.</param>
    /// <param name="northDegrees">Northern border.</param>
    /// <param name="westDegrees">Western border.</param>
    /// <param name="widthDegrees">How far the band goes to the east.</param>
    public IEnumerable<Boulder> Near(double southDegrees, double northDegrees, double westDegrees, double widthDegrees)
    {
        for (int octave = (int)Math.Floor(PortableMath.Log2(smallest)); Math.ScaleB(1.0, octave) < Largest; octave++)
        {
            double min = Math.ScaleB(1.0, octave);
            double reach = double.RadiansToDegrees(min / MoonConstants.ReferenceRadius);
            foreach (CraterCell cell in new CraterCells(octave).Near(southDegrees, northDegrees, westDegrees, widthDegrees, reach))
            {
                foreach (Boulder boulder in memory.Get(octave, cell, InCell))
                {
                    yield return boulder;
                }
            }
        }
    }

    /// <summary>log2 of m: diameters of the smallest craters that have thrown boulders of an octave.</summary>
    private static int LeastCraterOctave(int octave) =>
        (int)Math.Ceiling(1.5 * (octave + 1 - PortableMath.Log2(0.3)));

    private static Boulder Place(ref SplitMix64 random, Vector3D centre, int octave)
    {
        double part = 1.0 - (random.NextUniform() * (1.0 - PortableMath.Exp2(-Exponent)));
        double length = Math.ScaleB(PortableMath.Pow(part, -1.0 / Exponent), octave);
        double width = LeastWidth + (random.NextUniform() * (1.0 - LeastWidth));
        double height = length * (LeastHeight + (random.NextUniform() * (HighestHeight - LeastHeight)));
        (double sinTurn, double cosTurn) = PortableMath.SinCosDegrees(180.0 * random.NextUniform());
        Vector3D east = new Vector3D(-centre.Y, centre.X, 0.0).Normalized();
        Vector3D narrow = (cosTurn * east) + (sinTurn * Vector3D.Cross(centre, east));
        return new Boulder(centre, narrow, 0.5 * length, width, height, new BoulderForm(ref random));
    }

    /// <summary>Whether the ground shows the craters around which boulders of an octave lie.</summary>
    private bool HasCraters(int octave) => octave >= LeastOctaveAroundCraters
        && Math.ScaleB(1.0, LeastCraterOctave(octave) + CraterOctaves) <= craters.Largest;

    /// <summary>
    /// The boulders of an octave of lengths in a cell: as many as anywhere in the cell lie most densely, of which those stay that the
    /// density in their place allows.
    /// </summary>
    private IEnumerable<Boulder> InCell(int octave, CraterCell cell)
    {
        Vector3D middle = DirectionOf(cell, 0.5, 0.5);
        PlacedCrater[] near = HasCraters(octave) ? [.. CratersAround(octave, middle, HalfDiagonal(cell, middle))] : [];
        double everywhere = HasCraters(octave) ? 1.0 - PartAroundCraters : 1.0;
        double most = everywhere + near.Sum(crater => PartOf(crater, middle, HalfDiagonal(cell, middle)));
        double min = Math.ScaleB(1.0, octave);
        double mean = most * (CountAbove(min) - CountAbove(2.0 * min)) * cell.Area;
        SplitMix64 random = SplitMix64.For(seed, Purpose + ((ulong)octave << 8), cell.Band, cell.Column);
        double none = PortableMath.Exp2(-mean / 0.69314718055994530942);
        for (double product = random.NextUniform(); product > none; product *= random.NextUniform())
        {
            Vector3D centre = DirectionOf(cell, random.NextUniform(), random.NextUniform());
            double kept = most * random.NextUniform();
            if (kept < everywhere + near.Sum(crater => PartOf(crater, centre, 0.0)))
            {
                yield return Place(ref random, centre, octave);
            }
        }
    }

    private IEnumerable<PlacedCrater> CratersAround(int octave, Vector3D middle, double halfDiagonal)
    {
        SelenographicPoint point = SelenographicPoint.Below(middle);
        (double latitude, double longitude) = (double.RadiansToDegrees(point.Latitude), double.RadiansToDegrees(point.Longitude));
        for (int around = LeastCraterOctave(octave); around < LeastCraterOctave(octave) + CraterOctaves; around++)
        {
            double reach = halfDiagonal + (Outermost * Math.ScaleB(1.0, around) / MoonConstants.ReferenceRadius);
            foreach (CraterCell cell in new CraterCells(around).Near(latitude, latitude, longitude, 0.0, double.RadiansToDegrees(reach)))
            {
                foreach (PlacedCrater crater in craters.PlacedInCell(around, cell))
                {
                    if (crater.Freshness >= FreshFrom && PartOf(crater, middle, halfDiagonal) > 0.0)
                    {
                        yield return crater;
                    }
                }
            }
        }
    }

    /// <summary>The most boulders of a crater within a distance from a place, in those of the law over the same area.</summary>
    private static double PartOf(in PlacedCrater crater, Vector3D place, double within)
    {
        double distance = Distance(place, crater.Direction);
        double nearest = Math.Max(distance - within, Innermost * crater.Radius) / crater.Radius;
        return nearest > Outermost || distance + within < Innermost * crater.Radius ? 0.0 : AtRim / (nearest * nearest * nearest);
    }

    private static Vector3D DirectionOf(CraterCell cell, double up, double right)
    {
        (double sinLatitude, double longitude) = cell.Place(up, right);
        return new Crater(sinLatitude, longitude, 0.0, 1.0).Direction;
    }

    private static double HalfDiagonal(CraterCell cell, Vector3D middle) => Math.Max(
        Math.Max(Distance(DirectionOf(cell, 0.0, 0.0), middle), Distance(DirectionOf(cell, 1.0, 0.0), middle)),
        Math.Max(Distance(DirectionOf(cell, 0.0, 1.0), middle), Distance(DirectionOf(cell, 1.0, 1.0), middle)));

    private static double Distance(Vector3D a, Vector3D b) => Math.Sqrt((a - b).LengthSquared);
}
