namespace Msisf.Core.Surface;

/// <summary>Sines and cosines of every latitude and longitude of an elevation grid; safe for several threads.</summary>
/// <remarks>
/// All of them follow from the sines of (2k + 1) / (2 res) degrees in the first quadrant, so one table serves the whole Moon.
/// </remarks>
public sealed class GridDirections
{
    private readonly int _pixelsPerDegree;
    private readonly int _quadrant;
    private readonly double[]? _sines;

    /// <summary>Computes the table.</summary>
    /// <param name="pixelsPerDegree">Samples per degree, at least 1.</param>
    /// <param name="hasTable">Whether all are computed now; of a map of a small part of the Moon few are needed.</param>
    public GridDirections(int pixelsPerDegree, bool hasTable = true)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(pixelsPerDegree, 1);
        (_pixelsPerDegree, _quadrant) = (pixelsPerDegree, 90 * pixelsPerDegree);
        if (!hasTable)
        {
            return;
        }

        double[] sines = new double[_quadrant];
        for (int k = 0; k < sines.Length; k++)
        {
            sines[k] = Sine(k);
        }

        _sines = sines;
    }

    /// <summary>
    /// Sine and cosine of the latitude of a vertex line, 90 - (2 line + 1) / (2 res) degrees; line -1 is the north pole and line 180 res
    /// the south pole.
    /// </summary>
    public SineCosine Latitude(int line)
    {
        int lines = 2 * _quadrant;
        if (line < 0 || line >= lines)
        {
            return new SineCosine(line < 0 ? 1.0 : -1.0, 0.0);
        }

        return line < _quadrant
            ? new SineCosine(Sine(_quadrant - 1 - line), Sine(line))
            : new SineCosine(-Sine(line - _quadrant), Sine(lines - 1 - line));
    }

    /// <summary>Sine and cosine of the longitude of a sample, (2 sample + 1) / (2 res) degrees.</summary>
    public SineCosine Longitude(int sample)
    {
        int k = sample % _quadrant;
        double rising = Sine(k);
        double falling = Sine(_quadrant - 1 - k);
        return (sample / _quadrant) switch
        {
            0 => new SineCosine(rising, falling),
            1 => new SineCosine(falling, -rising),
            2 => new SineCosine(-rising, -falling),
            _ => new SineCosine(-falling, rising),
        };
    }

    private double Sine(int k) => _sines is { } sines ? sines[k] : DegreeTrigonometry.Sin((2 * k) + 1, 2 * _pixelsPerDegree);
}
