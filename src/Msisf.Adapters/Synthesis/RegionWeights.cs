using Msisf.Core.Terrain;

namespace Msisf.Adapters.Synthesis;

/// <summary>
/// How much of the detail each sample of the whole Moon's grid gets: 1 in the region, fading to 0 beyond its border. The weight of a sample
/// is that of its line times that of its column.
/// </summary>
internal sealed class RegionWeights
{
    private readonly float[] _lines;
    private readonly float[] _columns;

    /// <summary>Computes the weights.</summary>
    /// <param name="region">The part with full detail.</param>
    /// <param name="pixelsPerDegree">Samples a degree.</param>
    /// <param name="fadeDegrees">Where the detail ends, degrees beyond the border; 0 for a sharp border.</param>
    public RegionWeights(MoonRegion region, int pixelsPerDegree, double fadeDegrees)
    {
        double fade = fadeDegrees * pixelsPerDegree;
        _lines = new float[180 * pixelsPerDegree];
        _columns = new float[360 * pixelsPerDegree];
        for (int line = 0; line < _lines.Length; line++)
        {
            int first = (90 - region.NorthDegrees) * pixelsPerDegree;
            int last = ((90 - region.SouthDegrees) * pixelsPerDegree) - 1;
            _lines[line] = Weight(Math.Max(first - line, line - last), fade);
        }

        int west = region.WestDegrees * pixelsPerDegree;
        int samples = (region.EastDegrees - region.WestDegrees) * pixelsPerDegree;
        for (int column = 0; column < _columns.Length; column++)
        {
            int eastward = (column - west + _columns.Length) % _columns.Length; // from the western border
            int outside = eastward < samples ? 0 : Math.Min(eastward - samples + 1, _columns.Length - eastward);
            _columns[column] = Weight(outside, fade);
        }
    }

    /// <summary>The smallest block of lines that holds all lines with detail of a block; its count is 0 if there are none.</summary>
    public (int First, int Count) LinesWithDetail(int first, int count) => Extent(_lines, first, count);

    /// <summary>The same for the columns.</summary>
    public (int First, int Count) ColumnsWithDetail(int first, int count) => Extent(_columns, first, count);

    /// <summary>The weight of one sample, 0 to 1.</summary>
    public float At(int line, int column) => _lines[line] * _columns[column];

    private static (int First, int Count) Extent(float[] weights, int first, int count)
    {
        ReadOnlySpan<float> block = weights.AsSpan(first, count);
        int begin = block.IndexOfAnyExcept(0.0f);
        return begin < 0 ? (first, 0) : (first + begin, block.LastIndexOfAnyExcept(0.0f) - begin + 1);
    }

    /// <summary>1 inside, then a smooth step (3 t^2 - 2 t^3) down to 0.</summary>
    private static float Weight(int samplesOutside, double fade)
    {
        if (samplesOutside <= 0)
        {
            return 1.0f;
        }

        double t = Math.Clamp(1.0 - (samplesOutside / (fade + 1.0)), 0.0, 1.0);
        return samplesOutside > fade ? 0.0f : (float)(t * t * (3.0 - (2.0 * t)));
    }
}
