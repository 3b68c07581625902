using Msisf.Core.Parallel;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Sampling;

/// <summary>
/// Takes further samples where they matter. It starts from a frame with one sample a pixel, whose blocks of terrain it draws again, once
/// for all samples. One object serves many frames, one at a time.
/// </summary>
internal sealed class SamplingPass
{
    /// <summary>Samples of the bands that are lit and shaded together; bounds the memory.</summary>
    private const long SamplesAtOnce = 1 << 20;

    private readonly SampleChooser _chooser = new();
    private readonly SampleTrials _trials = new();
    private readonly List<SubsampleWorker> _workers = [];
    private readonly List<PixelParts> _parts = [];
    private readonly List<int> _firstRows = [];
    private readonly PartRows _rows = new();
    private readonly PixelSunlight _sunlight = new();
    private SurfaceModel _surface;
    private double[] _factors = [];

    /// <summary>Makes a pass for a surface.</summary>
    public SamplingPass(SurfaceModel surface) => _surface = surface;

    /// <summary>Samples another surface from the next frame on; the memory is kept.</summary>
    public void Show(SurfaceModel surface) => _surface = surface;

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
        AdaptiveSampling sampling = options.Adaptive!;
        _chooser.Classify(frame.Surface, radianceFactors, sunlight, sampling, threads, cancellation);
        while (_workers.Count < threads)
        {
            _workers.Add(new SubsampleWorker());
        }

        Work work = new(frame, light, lights, options, radianceFactors, threads, cancellation);
        List<int> trials = _chooser.ChooseTrials(sampling.Error, threads, cancellation);
        _trials.Begin(trials, radianceFactors, _chooser.Means);
        _chooser.Try(trials);
        Draw(work, isTrial: true);
        byte[] codes = SampleBudget.CodesOf(_chooser.Histogram, _trials.Sum(_chooser, sampling.Grey), sampling.Error);
        _chooser.Spread(codes, trials, radianceFactors, threads, cancellation);
        Draw(work, isTrial: false);
    }

    /// <summary>Draws the chosen samples of all pixels and replaces their brightness.</summary>
    /// <param name="work">The frame.</param>
    /// <param name="isTrial">Whether the trials are told of each sample.</param>
    private void Draw(Work work, bool isTrial)
    {
        IReadOnlyList<SampledBand> bands = _chooser.Pixels.Bands;
        for (int first = 0; first < bands.Count;)
        {
            int end = first + 1;
            long samples = bands[first].Vectors * SamplePattern.Lanes;
            while (end < bands.Count && samples + (bands[end].Vectors * SamplePattern.Lanes) <= SamplesAtOnce)
            {
                samples += bands[end++].Vectors * SamplePattern.Lanes;
            }

            DrawBands(work, (first, end), isTrial);
            first = end;
        }
    }

    private void DrawBands(Work work, (int First, int End) bands, bool isTrial)
    {
        VisibilityPass frame = work.Frame;
        int count = bands.End - bands.First;
        int lists = isTrial ? 2 * count : count; // a trial's second half: the parts merged
        while (_parts.Count < lists)
        {
            _parts.Add(new PixelParts());
        }

        WorkerTeam.Run(
            work.Threads,
            count,
            (worker, index) => _workers[worker].Draw(
                _surface, frame, _chooser.Pixels, _chooser.Pixels.Bands[bands.First + index], _parts[index],
                isTrial ? _parts[count + index] : null),
            work.Cancellation);
        _rows.Begin(frame.View);
        _firstRows.Clear();
        for (int index = 0; index < lists; index++)
        {
            _firstRows.Add(_rows.Add(_parts[index]));
        }

        int room = _rows.Height * PartRows.RowLength;
        if (_factors.Length < room)
        {
            _factors = new double[room];
        }

        work.Lights.Run(
            _rows, work.Light, work.Options, new SampleWeight(1.0, IsFirst: true), _sunlight, _factors, work.Threads, work.Cancellation);
        WorkerTeam.Run(work.Threads, count, (_, index) =>
        {
            Collect(_parts[index], FactorsOf(index), work, _chooser.Pixels.Bands[bands.First + index]);
            if (isTrial)
            {
                _trials.TakeSamples(_parts[index], FactorsOf(index));
                _trials.TakeMerged(_parts[count + index], FactorsOf(count + index));
            }
        }, work.Cancellation);
    }

    private ReadOnlySpan<double> FactorsOf(int list) => _factors.AsSpan(_firstRows[list] * PartRows.RowLength, _parts[list].Count);

    /// <summary>Replaces the brightness of a band's pixels with further samples.</summary>
    private void Collect(PixelParts parts, ReadOnlySpan<double> factors, Work work, SampledBand band)
    {
        int width = work.Frame.View.Camera.Width;
        int first = band.FirstRow * width;
        int end = (band.LastRow + 1) * width;
        ReadOnlySpan<byte> codes = _chooser.Pixels.Codes.AsSpan(0, end);
        for (int next; first < end && (next = codes[first..].IndexOfAnyExcept((byte)0)) >= 0; first += next + 1)
        {
            work.RadianceFactors[first + next] = 0.0;
        }

        for (int part = 0; part < parts.Count; part++)
        {
            work.RadianceFactors[parts.Pixels[part]] += parts.Weights[part] * factors[part];
        }
    }

    /// <summary>A frame and what it is drawn with.</summary>
    private sealed record Work(
        VisibilityPass Frame, SceneLight Light, LightPass Lights, NativeRenderOptions Options, double[] RadianceFactors, int Threads,
        CancellationToken Cancellation);
}
