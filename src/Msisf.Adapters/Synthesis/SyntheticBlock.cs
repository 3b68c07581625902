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
