using Msisf.Core.Numerics;

namespace Msisf.Core.Tiles;

/// <summary>Sines and cosines of every latitude and longitude of an elevation grid; safe for several threads.</summary>
/// <remarks>All of them are sines of (2k + 1) / (2 res) degrees in the first quarter: one table serves the whole Moon.</remarks>
public sealed class GridDirections
{
    private readonly double[] sines;

    /// <summary>Computes the table.</summary>
    /// <param name="pixelsPerDegree">Samples a degree, at least 1.</param>
    public GridDirections(int pixelsPerDegree)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(pixelsPerDegree, 1);
        sines = new double[90 * pixelsPerDegree];
        for (int k = 0; k < sines.Length; k++)
        {
            sines[k] = DegreeTrigonometry.Sin((2 * k) + 1, 2 * pixelsPerDegree);
        }
    }

    /// <summary>The latitude of a line: 90 - (2 line + 1) / (2 res) degrees.</summary>
    public SineCosine Latitude(int line)
    {
        int lines = 2 * sines.Length;
        return line < sines.Length
            ? new SineCosine(sines[sines.Length - 1 - line], sines[line])
            : new SineCosine(-sines[line - sines.Length], sines[lines - 1 - line]);
    }

    /// <summary>The longitude of a sample: (2 sample + 1) / (2 res) degrees.</summary>
    public SineCosine Longitude(int sample)
    {
        int k = sample % sines.Length;
        double rising = sines[k];
        double falling = sines[sines.Length - 1 - k];
        return (sample / sines.Length) switch
        {
            0 => new SineCosine(rising, falling),
            1 => new SineCosine(falling, -rising),
            2 => new SineCosine(-rising, -falling),
            _ => new SineCosine(-falling, rising),
        };
    }
}
