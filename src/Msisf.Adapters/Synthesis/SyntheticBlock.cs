using Msisf.Core.Terrain;
using Msisf.Synthesis;

namespace Msisf.Adapters.Synthesis;

/// <summary>Computes blocks of a synthetic product: detail in its region, the rest around it. Belongs to one thread.</summary>
internal sealed class SyntheticBlock
{
    private const int LargestSampleBytes = sizeof(float);

    private readonly TileSynthesizer _synthesizer;
    private readonly SyntheticRest _rest;
    private readonly RegionWeights _weights;
    private readonly int _side;
    private float[] _detailed = [];

    /// <summary>Prepares to compute.</summary>
    /// <param name="terrain">The model.</param>
    /// <param name="rest">What lies outside the region.</param>
    /// <param name="weights">How much of the detail each sample gets.</param>
    /// <param name="side">Samples along the side of the largest block.</param>
    public SyntheticBlock(SyntheticTerrain terrain, SyntheticRest rest, RegionWeights weights, int side)
    {
        _synthesizer = new TileSynthesizer(terrain);
        _rest = rest;
        _weights = weights;
        _side = side;
        Heights = new float[side * side];
        Bytes = new byte[LargestSampleBytes * side];
    }

    /// <summary>The heights of the last block, m over the reference radius, line by line.</summary>
    public float[] Heights { get; }

    /// <summary>Room for the samples of one line.</summary>
    public byte[] Bytes { get; }

    /// <summary>Computes a block of the whole Moon's grid into <see cref="Heights"/>.</summary>
    /// <returns>False if all of it is flat.</returns>
    public bool TryCompute(int firstLine, int lines, int firstSample, int samples)
    {
        (int detailLine, int detailLines) = _weights.LinesWithDetail(firstLine, lines);
        (int detailSample, int detailSamples) = _weights.ColumnsWithDetail(firstSample, samples);
        if (detailLines == lines && detailSamples == samples && IsAllDetail(firstLine, lines, firstSample, samples))
        {
            _synthesizer.Synthesize(firstLine, lines, firstSample, samples, Heights);
            return true;
        }

        bool hasDetail = detailLines > 0 && detailSamples > 0;
        if (_rest == SyntheticRest.Base)
        {
            _synthesizer.Interpolate(firstLine, lines, firstSample, samples, Heights);
        }
        else if (hasDetail)
        {
            Array.Clear(Heights, 0, lines * samples);
        }
        else
        {
            return false;
        }

        if (hasDetail)
        {
            Blend(firstLine, firstSample, samples, (detailLine, detailLines), (detailSample, detailSamples));
        }

        return true;
    }

    private bool IsAllDetail(int firstLine, int lines, int firstSample, int samples)
    {
        for (int line = firstLine; line < firstLine + lines; line++)
        {
            for (int sample = firstSample; sample < firstSample + samples; sample++)
            {
                if (_weights.At(line, sample) < 1.0f)
                {
                    return false;
                }
            }
        }

        return true;
    }

    private void Blend(int firstLine, int firstSample, int samples, (int First, int Count) lines, (int First, int Count) columns)
    {
        if (_detailed.Length == 0)
        {
            _detailed = new float[_side * _side];
        }

        _synthesizer.Synthesize(lines.First, lines.Count, columns.First, columns.Count, _detailed);
        for (int line = 0; line < lines.Count; line++)
        {
            Span<float> row = Heights.AsSpan(
                ((lines.First + line - firstLine) * samples) + columns.First - firstSample, columns.Count);
            ReadOnlySpan<float> detailed = _detailed.AsSpan(line * columns.Count, columns.Count);
            for (int sample = 0; sample < columns.Count; sample++)
            {
                float weight = _weights.At(lines.First + line, columns.First + sample);
                row[sample] = weight == 1.0f ? detailed[sample] : row[sample] + (weight * (detailed[sample] - row[sample]));
            }
        }
    }
}

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
