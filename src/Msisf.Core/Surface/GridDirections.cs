using Msisf.Core.Numerics;

namespace Msisf.Core.Surface;

/// <summary>Sines and cosines of every latitude and longitude of an elevation grid; safe for several threads.</summary>
/// <remarks>
/// All of them follow from the sines of (2k + 1) / (2 res) degrees in the first quadrant, so one table serves the whole Moon.
/// </remarks>
public sealed class GridDirections
{
    private readonly double[] _sines;

    /// <summary>Computes the table.</summary>
    /// <param name="pixelsPerDegree">Samples per degree, at least 1.</param>
    public GridDirections(int pixelsPerDegree)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(pixelsPerDegree, 1);
        _sines = new double[90 * pixelsPerDegree];
        for (int k = 0; k < _sines.Length; k++)
        {
            _sines[k] = DegreeTrigonometry.Sin((2 * k) + 1, 2 * pixelsPerDegree);
        }
    }

    /// <summary>
    /// Sine and cosine of the latitude of a vertex line, 90 - (2 line + 1) / (2 res) degrees; line -1 is the north pole and line 180 res
    /// the south pole.
    /// </summary>
    public SineCosine Latitude(int line)
    {
        int lines = 2 * _sines.Length;
        if (line < 0 || line >= lines)
        {
            return new SineCosine(line < 0 ? 1.0 : -1.0, 0.0);
        }

        return line < _sines.Length
            ? new SineCosine(_sines[_sines.Length - 1 - line], _sines[line])
            : new SineCosine(-_sines[line - _sines.Length], _sines[lines - 1 - line]);
    }

    /// <summary>Sine and cosine of the longitude of a sample, (2 sample + 1) / (2 res) degrees.</summary>
    public SineCosine Longitude(int sample)
    {
        int k = sample % _sines.Length;
        double rising = _sines[k];
        double falling = _sines[_sines.Length - 1 - k];
        return (sample / _sines.Length) switch
        {
            0 => new SineCosine(rising, falling),
            1 => new SineCosine(falling, -rising),
            2 => new SineCosine(-rising, -falling),
            _ => new SineCosine(-falling, rising),
        };
    }
}
