using Msisf.Core.Parallel;
using Msisf.Core.Render.Indirect;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;

namespace Msisf.Core.Render.Sampling;

/// <summary>
/// Takes further samples where they matter. It starts from a frame with one sample a pixel, whose blocks of terrain it draws again, once
/// for all samples. One object serves many frames, one at a time.
/// </summary>
/// <param name="pass">Finds the parts of pixels, their light and their brightness.</param>
internal sealed class SamplingPass(PartPass pass)
{
    /// <summary>Samples of the bands that are lit and shaded together; bounds the memory.</summary>
    private const long SamplesAtOnce = 1 << 20;

    private readonly SampleChooser _chooser = new();
    private readonly SampleTrials _trials = new();
    private readonly List<PixelParts> _parts = [];

    /// <summary>Replaces the brightness of the pixels that get further samples.</summary>
    /// <param name="frame">The frame with one sample a pixel, at the pixels' centres.</param>
    /// <param name="light">The Sun, or the lamp at the camera.</param>
    /// <param name="lights">Finds light and brightness.</param>
    /// <param name="indirect">Finds the light of the ground, if the settings ask for it; it has been begun.</param>
    /// <param name="options">The settings; with <see cref="NativeRenderOptions.Adaptive"/>.</param>
    /// <param name="sunlight">The light on the pixels' centres.</param>
    /// <param name="radianceFactors">The brightness of the pixels' centres; receives that of the pixels.</param>
    /// <param name="threads">Maximum number of threads; the result does not depend on it.</param>
    public void Run(
        VisibilityPass frame, SceneLight light, LightPass lights, IndirectPass indirect, NativeRenderOptions options,
        PixelSunlight sunlight, double[] radianceFactors, int threads, CancellationToken cancellation)
    {
        AdaptiveSampling sampling = options.Adaptive!;
        _chooser.Classify(frame.Surface, radianceFactors, sunlight, sampling, threads, cancellation);
        SampledFrame work = new(frame, light, lights, indirect, options, radianceFactors, threads, cancellation);
        List<int> trials = _chooser.ChooseTrials(sampling.Error, threads, cancellation);
        _trials.Begin(trials, radianceFactors, _chooser.Means);
        _chooser.Try(trials);
        Draw(work, isTrial: true);
        byte[] codes = SampleBudget.CodesOf(_chooser.Histogram, _trials.Sum(_chooser, sampling.Grey), sampling.Error);
        _chooser.Spread(codes, trials, radianceFactors, threads, cancellation);
        Draw(work, isTrial: false);
    }

    /// <summary>Draws the chosen samples of all pixels and replaces their brightness.</summary>
    /// <param name="isTrial">Whether the trials are told of each sample.</param>
    private void Draw(SampledFrame work, bool isTrial)
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

    private void DrawBands(SampledFrame work, (int First, int End) bands, bool isTrial)
    {
        int count = bands.End - bands.First;
        int lists = isTrial ? 2 * count : count; // a trial's second half: the parts merged
        pass.Find(work, _chooser.Pixels, bands, _parts, withMerged: isTrial);
        pass.Light(work, _parts, lists);
        WorkerTeam.Run(work.Threads, count, (_, index) =>
        {
            Clear(work, _chooser.Pixels.Bands[bands.First + index]);
            pass.Collect(work, index, _parts[index]);
            if (isTrial)
            {
                _trials.TakeSamples(_parts[index], pass.FactorsOf(index, _parts[index]));
                _trials.TakeMerged(_parts[count + index], pass.FactorsOf(count + index, _parts[count + index]));
            }
        }, work.Cancellation);
    }

    /// <summary>Forgets the brightness of the pixels of a band that get further samples.</summary>
    private void Clear(SampledFrame work, SampledBand band)
    {
        int width = work.Frame.View.Camera.Width;
        int first = band.FirstRow * width;
        int end = (band.LastRow + 1) * width;
        ReadOnlySpan<byte> codes = _chooser.Pixels.Codes.AsSpan(0, end);
        for (int next; first < end && (next = codes[first..].IndexOfAnyExcept((byte)0)) >= 0; first += next + 1)
        {
            work.RadianceFactors[first + next] = 0.0;
        }
    }
}

/// <summary>A frame whose pixels get several samples, and what it is drawn with.</summary>
/// <param name="Frame">Knows the blocks of terrain that the frame may show.</param>
/// <param name="Light">The Sun, or the lamp at the camera.</param>
/// <param name="Lights">Finds light and brightness.</param>
/// <param name="Indirect">Finds the light of the ground; null where none is asked for.</param>
/// <param name="Options">The settings.</param>
/// <param name="RadianceFactors">The brightness of the pixels.</param>
/// <param name="Threads">Maximum number of threads; the result does not depend on it.</param>
internal sealed record SampledFrame(
    VisibilityPass Frame, SceneLight Light, LightPass Lights, IndirectPass? Indirect, NativeRenderOptions Options,
    double[] RadianceFactors, int Threads, CancellationToken Cancellation);
