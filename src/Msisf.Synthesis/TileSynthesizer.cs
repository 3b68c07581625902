namespace Msisf.Synthesis;

/// <summary>
/// Computes blocks of a <see cref="SyntheticTerrain"/>. Keeps its buffers from block to block, so it belongs to one thread;
/// a sample's height does not depend on the block in which it is computed.
/// </summary>
public sealed class TileSynthesizer
{
    private const long LargestBuffers = 27_000_000; // samples, with margins and without: 108 MB
    private const int LargestSideDegrees = 20; // the margins cost under a sixth, the tables stay in the second-level cache

    private readonly SyntheticTerrain _terrain;
    private readonly int _margin;
    private float[] _detail = [];

    /// <summary>Prepares to compute blocks of a model.</summary>
    /// <param name="terrain">The model.</param>
    public TileSynthesizer(SyntheticTerrain terrain)
    {
        _terrain = terrain;
        _margin = terrain.HasBase ? PixelMeanKernel.Reach : 0;
    }

    /// <summary>Samples along the side of a block of efficient size: a multiple of the samples of a base pixel.</summary>
    public int PreferredSide
    {
        get
        {
            int pixels = LargestSideDegrees * _terrain.Base.PixelsPerDegree;
            while (pixels > 1 && BufferSamples(pixels) > LargestBuffers)
            {
                pixels--;
            }

            return _terrain.SamplesPerPixel * pixels;
        }
    }

    /// <summary>
    /// Memory, bytes, that a thread needs for a block of <see cref="PreferredSide"/>: the detail with its margins, and the heights.
    /// </summary>
    public long PreferredBytes => sizeof(float) * BufferSamples(PreferredSide / _terrain.SamplesPerPixel);

    /// <summary>Computes one block.</summary>
    /// <param name="firstLine">Northernmost line, 0 to 180 res - 1.</param>
    /// <param name="lines">How many lines.</param>
    /// <param name="firstSample">Westernmost sample, 0 to 360 res - 1.</param>
    /// <param name="samples">How many samples, at most 90 degrees of them.</param>
    /// <param name="heights">Filled with m over the reference radius, line by line.</param>
    public void Synthesize(int firstLine, int lines, int firstSample, int samples, Span<float> heights)
    {
        int n = _terrain.SamplesPerPixel;
        int firstPixelLine = firstLine / n;
        int firstPixel = firstSample / n;
        int pixelLines = ((firstLine + lines + n - 1) / n) - firstPixelLine;
        int pixels = ((firstSample + samples + n - 1) / n) - firstPixel;
        TileFrame frame = new(
            _terrain.PixelsPerDegree,
            (firstPixelLine - _margin) * n,
            (pixelLines + (2 * _margin)) * n,
            (firstPixel - _margin) * n,
            (pixels + (2 * _margin)) * n);
        AddDetail(frame);
        BaseSurface surface = new(_terrain, firstPixelLine, pixelLines, firstPixel, pixels);
        if (_terrain.HasBase)
        {
            surface.TakeOffMeans(frame, _detail);
        }

        surface.Prepare();
        for (int line = 0; line < lines; line++)
        {
            Span<float> row = heights.Slice(line * samples, samples);
            int detailStart = ((firstLine + line - frame.FirstLine) * frame.Stride) + firstSample - frame.FirstSample;
            surface.ReadLine(firstLine + line, firstSample, _detail.AsSpan(detailStart, samples), row);
        }
    }

    /// <summary>Interpolates the base over one block, without any detail.</summary>
    /// <inheritdoc cref="Synthesize"/>
    public void Interpolate(int firstLine, int lines, int firstSample, int samples, Span<float> heights)
    {
        int n = _terrain.SamplesPerPixel;
        int firstPixelLine = firstLine / n;
        int firstPixel = firstSample / n;
        BaseSurface surface = new(
            _terrain,
            firstPixelLine,
            ((firstLine + lines + n - 1) / n) - firstPixelLine,
            firstPixel,
            ((firstSample + samples + n - 1) / n) - firstPixel);
        surface.Prepare();
        float[] noDetail = new float[samples];
        for (int line = 0; line < lines; line++)
        {
            surface.ReadLine(firstLine + line, firstSample, noDetail, heights.Slice(line * samples, samples));
        }
    }

    private long BufferSamples(int pixels)
    {
        long core = (long)pixels * _terrain.SamplesPerPixel;
        long withMargins = core + (2L * _margin * _terrain.SamplesPerPixel);
        return (core * core) + (withMargins * withMargins);
    }

    private void AddDetail(TileFrame frame)
    {
        int length = frame.Lines * frame.Stride;
        if (_detail.Length < length)
        {
            _detail = new float[length];
        }

        Array.Clear(_detail, 0, length);
        float[] maria = new float[frame.Stride];
        double[][] tables = [.. _terrain.Octaves.Select(octave => octave.ColumnTables(frame))];
        for (int line = 0; line < frame.Lines; line++)
        {
            _terrain.Maria.FillLine(frame, line, maria);
            Span<float> row = _detail.AsSpan(line * frame.Stride, frame.Stride);
            for (int i = 0; i < tables.Length; i++)
            {
                _terrain.Octaves[i].AddTo(tables[i], frame.SinLatitude[line], frame.CosLatitude[line], maria, row);
            }
        }

        foreach (Crater crater in _terrain.CratersNear(frame))
        {
            CraterStamp.AddTo(crater, frame, _detail);
        }
    }
}
