using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>All boulders of a seed, placed uniformly and independently; a boulder is the same for every block of ground.</summary>
/// <remarks>
/// Number: N(&gt;D) = 5e5 D^-2.11 for each 100 m2, D in mm, at Surveyor 1's site (E. M. Shoemaker, E. C. Morris, Icarus 12 (1970), 188).
/// Larger blocks are rarer than that (M. J. Cintala, K. M. McBride, NASA TM 104804 (1995)), so there is none above 4 m. Height: 0.3 to 0.9
/// of the length, 0.6 in the mean (N. E. Demidov, A. T. Basilevsky, Sol. Syst. Res. 48 (2014), 324).
/// </remarks>
/// <param name="seed">The user's seed.</param>
/// <param name="smallest">m: minimum length, a power of two.</param>
/// <param name="memory">Keeps those of the seed that were found.</param>
internal sealed class BoulderPopulation(ulong seed, double smallest, CellMemory<Boulder> memory)
{
    private const ulong Purpose = 7;
    private const double CountAboveOneMillimetre = 5e5 / 100.0; // per m2
    private const double Exponent = 2.11;
    private const double Largest = 4.0; // m
    private const double LeastWidth = 0.6; // lengths
    private const double LeastHeight = 0.3; // lengths
    private const double HighestHeight = 0.9;

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

    private IEnumerable<Boulder> InCell(int octave, CraterCell cell)
    {
        double min = Math.ScaleB(1.0, octave);
        double density = CountAbove(min) - CountAbove(2.0 * min);
        SplitMix64 random = SplitMix64.For(seed, Purpose + ((ulong)octave << 8), cell.Band, cell.Column);
        double none = PortableMath.Exp2(-density * cell.Area / 0.69314718055994530942);
        for (double product = random.NextUniform(); product > none; product *= random.NextUniform())
        {
            (double sinLatitude, double longitude) = cell.Place(random.NextUniform(), random.NextUniform());
            double part = 1.0 - (random.NextUniform() * (1.0 - PortableMath.Exp2(-Exponent)));
            double length = Math.ScaleB(PortableMath.Pow(part, -1.0 / Exponent), octave);
            double width = LeastWidth + (random.NextUniform() * (1.0 - LeastWidth));
            double height = length * (LeastHeight + (random.NextUniform() * (HighestHeight - LeastHeight)));
            (double sinTurn, double cosTurn) = PortableMath.SinCosDegrees(180.0 * random.NextUniform());
            (double sinLongitude, double cosLongitude) = PortableMath.SinCosDegrees(longitude);
            double cosLatitude = Math.Sqrt((1.0 - sinLatitude) * (1.0 + sinLatitude));
            Vector3D east = new(-sinLongitude, cosLongitude, 0.0);
            Vector3D north = new(-sinLatitude * cosLongitude, -sinLatitude * sinLongitude, cosLatitude);
            yield return new Boulder(
                new Vector3D(cosLatitude * cosLongitude, cosLatitude * sinLongitude, sinLatitude),
                (cosTurn * east) + (sinTurn * north), 0.5 * length, width, height);
        }
    }
}
