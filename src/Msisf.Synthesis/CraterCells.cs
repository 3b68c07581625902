using System.Collections.Concurrent;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// Cells of the sphere for craters of one octave of diameters (2^k to 2^(k+1) m): bands of latitude, each cut into equal columns so that
/// the cells are about square. Within a cell all places are equally likely, also at the poles.
/// </summary>
internal sealed class CraterCells
{
    private const double DiametersPerCell = 4.0;

    private readonly int _bands;

    /// <summary>The cells of an octave.</summary>
    /// <param name="octave">k.</param>
    public CraterCells(int octave)
    {
        double side = DiametersPerCell * Math.ScaleB(2.0, octave);
        _bands = Math.Max(2, (int)(Math.PI * MoonConstants.ReferenceRadius / side));
    }

    /// <summary>The cells from which a crater can reach into a block, by band and then by column.</summary>
    /// <param name="southDegrees">Southern border of the block; below -90 beyond the pole.</param>
    /// <param name="northDegrees">Northern border; above 90 beyond the pole.</param>
    /// <param name="westDegrees">Western border.</param>
    /// <param name="widthDegrees">Width of the block.</param>
    /// <param name="reachDegrees">How far a crater can reach, as an angle at the Moon's centre, degrees.</param>
    public IEnumerable<CraterCell> Near(
        double southDegrees,
        double northDegrees,
        double westDegrees,
        double widthDegrees,
        double reachDegrees)
    {
        double south = southDegrees - reachDegrees;
        double north = northDegrees + reachDegrees;

        // Lines beyond a pole lie on the opposite meridian, so all columns of the bands that they fold back to are taken.
        double allColumnsNorthOf = north > 90.0 ? 180.0 - north : 90.0;
        double allColumnsSouthOf = south < -90.0 ? -180.0 - south : -90.0;
        int firstBand = BandOf(Math.Min(south, allColumnsNorthOf));
        int lastBand = BandOf(Math.Max(north, allColumnsSouthOf));
        for (int band = firstBand; band <= lastBand; band++)
        {
            double northBorder = BorderDegrees(band + 1);
            double southBorder = BorderDegrees(band);
            CraterCell first = First(band, southBorder, northBorder);
            int columns = first.Columns;
            double cos = PortableMath.SinCosDegrees(Math.Max(Math.Abs(northBorder), Math.Abs(southBorder))).Cos;

            // asin(sin(reach) / cos(latitude)) is the half width; pi/2 times its argument is an upper bound.
            double half = 0.5 * Math.PI * reachDegrees / cos;
            bool all = northBorder >= allColumnsNorthOf || southBorder <= allColumnsSouthOf
                || (2.0 * half) + widthDegrees + (720.0 / columns) >= 360.0;
            int west = all ? 0 : (int)Math.Floor((westDegrees - half) * columns / 360.0);
            int count = all ? columns : (int)Math.Floor((westDegrees + widthDegrees + half) * columns / 360.0) - west + 1;
            west = ((west % columns) + columns) % columns;

            // In ascending order, also across the prime meridian, because sums of overlapping craters must not depend on the block.
            for (int column = 0; column < west + count - columns; column++)
            {
                yield return first with { Column = column };
            }

            for (int column = west; column < Math.Min(columns, west + count); column++)
            {
                yield return first with { Column = column };
            }
        }
    }

    private double BorderDegrees(int border) => (180.0 * border / _bands) - 90.0;

    private int BandOf(double latitudeDegrees) => Math.Clamp((int)Math.Floor((latitudeDegrees + 90.0) / 180.0 * _bands), 0, _bands - 1);

    private CraterCell First(int band, double southBorder, double northBorder)
    {
        double cosMiddle = PortableMath.SinCosDegrees(0.5 * (southBorder + northBorder)).Cos;
        return new CraterCell(
            band,
            Column: 0,
            Math.Max(4, (int)(2.0 * _bands * cosMiddle)),
            PortableMath.SinCosDegrees(southBorder).Sin,
            PortableMath.SinCosDegrees(northBorder).Sin);
    }
}

/// <summary>One cell of <see cref="CraterCells"/>.</summary>
/// <param name="Band">Counted from the south.</param>
/// <param name="Column">Counted from longitude 0.</param>
/// <param name="Columns">Number of columns of the band.</param>
/// <param name="SouthSine">Sine of the southern border's latitude.</param>
/// <param name="NorthSine">Sine of the northern border's latitude.</param>
internal readonly record struct CraterCell(int Band, int Column, int Columns, double SouthSine, double NorthSine)
{
    /// <summary>Area of the cell on the reference sphere, m2.</summary>
    public double Area =>
        2.0 * Math.PI * MoonConstants.ReferenceRadius * MoonConstants.ReferenceRadius * (NorthSine - SouthSine) / Columns;

    /// <summary>A place in the cell; equal areas of the unit square are equal areas of the cell.</summary>
    /// <param name="up">[0, 1).</param>
    /// <param name="right">[0, 1).</param>
    public (double SinLatitude, double LongitudeDegrees) Place(double up, double right) =>
        (SouthSine + (up * (NorthSine - SouthSine)), (Column + right) * 360.0 / Columns);
}

/// <summary>
/// Keeps what was found in cells of <see cref="CraterCells"/>, since neighbouring blocks of ground ask for the same cells. Safe for several
/// threads.
/// </summary>
/// <typeparam name="T">What lies in cells.</typeparam>
internal sealed class CellMemory<T>
{
    /// <summary>Cells that are kept at most, some 10 MB; all are forgotten when there are more.</summary>
    private const int MostCells = 1 << 15;

    private readonly ConcurrentDictionary<(int Octave, int Band, int Column), T[]> _known = new();
    private int _count;

    /// <summary>What lies in a cell.</summary>
    /// <param name="octave">The cell's octave of diameters.</param>
    /// <param name="cell">The cell.</param>
    /// <param name="find">Finds it, the same each time.</param>
    public T[] Get(int octave, CraterCell cell, Func<int, CraterCell, IEnumerable<T>> find)
    {
        (int, int, int) key = (octave, cell.Band, cell.Column);
        if (_known.TryGetValue(key, out T[]? known))
        {
            return known;
        }

        if (Interlocked.Increment(ref _count) > MostCells)
        {
            _known.Clear();
            Interlocked.Exchange(ref _count, 1);
        }

        return _known[key] = [.. find(octave, cell)];
    }
}
