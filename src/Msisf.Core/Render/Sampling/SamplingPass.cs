using Msisf.Core.Mesh;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;

namespace Msisf.Core.Render.Sampling;

/// <summary>
/// Takes further samples where they matter. It starts from a frame with one sample a pixel, whose blocks of terrain it draws again, once
/// for all samples. One object serves many frames, one at a time.
/// </summary>
internal sealed class SamplingPass(SurfaceModel surface)
{
    /// <summary>Samples of the bands that are lit and shaded together; bounds the memory.</summary>
    private const long SamplesAtOnce = 1 << 20;

    private readonly SampleChooser _chooser = new();
    private readonly List<SubsampleWorker> _workers = [];
    private readonly List<PixelParts> _parts = [];
    private readonly List<int> _firstRows = [];
    private readonly PartRows _rows = new();
    private readonly PixelSunlight _sunlight = new();
    private double[] _factors = [];

    /// <summary>Replaces the brightness of the pixels that get further samples.</summary>
    /// <param name="frame">The frame with one sample a pixel, at the pixels' centres.</param>
    /// <param name="light">The Sun, or the lamp at the camera.</param>
    /// <param name="lights">Finds light and brightness.</param>
    /// <param name="options">The settings; with <see cref="NativeRenderOptions.Adaptive"/>.</param>
    /// <param name="sunlight">The light on the pixels' centres.</param>
    /// <param name="radianceFactors">The brightness of the pixels' centres; receives that of the pixels.</param>
    /// <param name="threads">Maximum number of threads; the result does not depend on it.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void Run(
        VisibilityPass frame, SceneLight light, LightPass lights, NativeRenderOptions options, PixelSunlight sunlight,
        double[] radianceFactors, int threads, CancellationToken cancellation)
    {
        ImageView view = frame.View;
        _chooser.Choose(frame.Surface, radianceFactors, sunlight, options.Adaptive!, threads, cancellation);
        SampledPixels pixels = _chooser.Pixels;
        while (_workers.Count < threads)
        {
            _workers.Add(new SubsampleWorker());
        }

        int bands = pixels.VectorsOfBand.Length;
        for (int first = 0; first < bands;)
        {
            int end = first + 1;
            long samples = pixels.VectorsOfBand[first] * SamplePattern.Lanes;
            while (end < bands && samples + (pixels.VectorsOfBand[end] * SamplePattern.Lanes) <= SamplesAtOnce)
            {
                samples += pixels.VectorsOfBand[end++] * SamplePattern.Lanes;
            }

            if (samples > 0)
            {
                DrawBands(frame, light, lights, options, radianceFactors, (first, end), threads, cancellation);
            }

            first = end;
        }
    }

    private void DrawBands(
        VisibilityPass frame, SceneLight light, LightPass lights, NativeRenderOptions options, double[] radianceFactors,
        (int First, int End) bands, int threads, CancellationToken cancellation)
    {
        int count = bands.End - bands.First;
        while (_parts.Count < count)
        {
            _parts.Add(new PixelParts());
        }

        WorkerTeam.Run(
            threads,
            count,
            (worker, index) => _workers[worker].Draw(surface, frame, _chooser.Pixels, bands.First + index, _parts[index]),
            cancellation);
        _rows.Begin(frame.View);
        _firstRows.Clear();
        for (int index = 0; index < count; index++)
        {
            _firstRows.Add(_rows.Add(_parts[index]));
        }

        int room = _rows.Height * PartRows.RowLength;
        if (_factors.Length < room)
        {
            _factors = new double[room];
        }

        _factors.AsSpan(0, room).Clear();
        lights.Run(_rows, light, options, weight: 1.0, _sunlight, _factors, threads, cancellation);
        int pixelsOfBand = SampledPixels.BandRows * frame.View.Camera.Width;
        int pixelsOfImage = frame.View.Camera.Height * frame.View.Camera.Width;
        WorkerTeam.Run(threads, count, (_, index) =>
        {
            int first = (bands.First + index) * pixelsOfBand;
            int end = Math.Min(first + pixelsOfBand, pixelsOfImage);
            Collect(
                _parts[index], _factors.AsSpan(_firstRows[index] * PartRows.RowLength), _chooser.Pixels.Codes.AsSpan(first, end - first),
                radianceFactors, first);
        }, cancellation);
    }

    private static void Collect(
        PixelParts parts, ReadOnlySpan<double> factors, ReadOnlySpan<byte> codes, double[] radianceFactors, int firstPixel)
    {
        for (int i = 0; i < codes.Length; i++)
        {
            if (codes[i] != 0)
            {
                radianceFactors[firstPixel + i] = 0.0;
            }
        }

        for (int part = 0; part < parts.Count; part++)
        {
            radianceFactors[parts.Pixels[part]] += parts.Weights[part] * factors[part];
        }
    }
}
