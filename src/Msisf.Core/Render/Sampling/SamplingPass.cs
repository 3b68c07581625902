using Msisf.Core.Camera;
using Msisf.Core.Parallel;
using Msisf.Core.Render.Indirect;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Sampling;

/// <summary>
/// Draws the further samples of pixels: a grid in each pixel, or more where they matter. The blocks of terrain are drawn once for all
/// samples of some rows; samples on the same facet share their brightness. One object serves many frames, one at a time.
/// </summary>
/// <param name="pass">Finds the parts of pixels, their light and their brightness.</param>
internal sealed class SamplingPass(PartPass pass)
{
    /// <summary>Samples of the bands that are lit and shaded together; bounds the memory.</summary>
    private const long SamplesAtOnce = 1 << 18;

    /// <summary>Pixels of the image in one of a map, from which on one point of it stands for a pixel's samples.</summary>
    private const double PixelsOfEvenMap = 4.0;

    private readonly SampleChooser _chooser = new();
    private readonly SampleTrials _trials = new();
    private readonly List<PixelParts> _parts = [];

    /// <summary>Gives each pixel the same samples, and the brightness that they have.</summary>
    /// <param name="work">The frame; its blocks are known.</param>
    /// <param name="pattern">The samples.</param>
    public void Run(SampledFrame work, SamplePattern pattern)
    {
        CameraModel model = work.Frame.View.Camera.Model;
        _chooser.Pixels.Fill(pattern, model.Width, model.Height, hasBorders: work.Light.IsSun || work.Lights.HasMap(work.Options));
        SampledFrame shared = work with
        {
            Pieces = FindPieces(work, pattern.Count * (double)model.Width * model.Height),
            LensSamples = work.Frame.FindLens(pattern, work.Threads, work.Cancellation),
        };
        Draw(shared, isTrial: false);
    }

    /// <summary>Chooses samples where they matter, and replaces the brightness of the pixels that get them.</summary>
    /// <param name="work">The frame with one sample a pixel, at the pixels' centres, whose brightness it has.</param>
    /// <param name="sampling">The error that is asked for.</param>
    /// <param name="sunlight">The light on the pixels' centres.</param>
    public void Run(SampledFrame work, AdaptiveSampling sampling, PixelSunlight sunlight)
    {
        _chooser.Classify(work.Frame.Surface, work.RadianceFactors, sunlight, sampling, work.Threads, work.Cancellation);
        List<int> trials = _chooser.ChooseTrials(sampling.Error, work.Threads, work.Cancellation);
        _trials.Begin(trials, work.RadianceFactors, _chooser.Means);
        _chooser.Try(trials);
        Draw(work, isTrial: true);
        byte[] codes = SampleBudget.CodesOf(_chooser.Histogram, _trials.Sum(_chooser, sampling.Grey), sampling.Error);
        _chooser.Spread(codes, trials, work.RadianceFactors, work.Threads, work.Cancellation);
        Draw(work, isTrial: false);
    }

    /// <summary>Finds on which pieces of facets the samples need not be looked at one by one; null if that would not be worth it.</summary>
    /// <param name="samples">Number of samples of the image.</param>
    private SurePieces? FindPieces(SampledFrame work, double samples)
    {
        double facets = 2.0 * work.Frame.Blocks.Count * CellBlock.Size * CellBlock.Size;
        SureLight? light = facets < samples
            ? work.Lights.FindSureLight(
                work.Frame.Blocks.Select(visible => visible.Block), work.Light, work.Options, work.Threads, work.Cancellation)
            : null;
        return work.Light.IsSun && light is null
            ? null
            : new SurePieces(work.Frame.View, work.Light.PositionBodyFixed, light, EvenDepth(work));
    }

    /// <summary>m: up to this depth a pixel is small beside those of all maps, so that their reflectance is linear in it.</summary>
    private double EvenDepth(SampledFrame work)
    {
        NativeRenderOptions options = work.Options;
        if (!work.Lights.HasMap(options))
        {
            return double.PositiveInfinity;
        }

        IEnumerable<AlbedoMap> maps = options.Albedo is { } whole ? options.AlbedoSites.Append(whole) : options.AlbedoSites;
        double finest = work.Lights.HasRays ? 0.0 : maps.Min(map => map.Extent.Height / map.Levels[0].Height); // rays are finer still
        return finest * pass.ReferenceRadius / (PixelsOfEvenMap * work.Frame.View.Camera.PixelTangent);
    }

    /// <summary>Draws the chosen samples of all pixels and replaces their brightness.</summary>
    /// <param name="isTrial">Whether each sample is reported to the trials.</param>
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
                PixelParts parts = _parts[index];
                _trials.TakeSamples(
                    parts, pass.FactorsOf(index, parts), pass.IndirectFactorsOf(index, parts), pass.FractionsOf(index, parts));
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
            if (work.IndirectFactors.Length > 0)
            {
                work.IndirectFactors[first + next] = 0.0;
            }
        }
    }
}

/// <summary>A frame whose pixels get several samples, and what it is drawn with.</summary>
/// <param name="Frame">Knows the blocks of terrain that the frame may show.</param>
/// <param name="Light">The Sun, or the lamp at the camera.</param>
/// <param name="Lights">Finds light and brightness.</param>
/// <param name="Indirect">Finds the light of the ground, if the settings ask for it; it has been begun.</param>
/// <param name="Options">The settings.</param>
/// <param name="RadianceFactors">The brightness of the pixels.</param>
/// <param name="IndirectFactors">The part of it that the ground's own light makes; empty if it is not asked for.</param>
/// <param name="Threads">Maximum number of threads; the result does not depend on it.</param>
internal sealed record SampledFrame(
    VisibilityPass Frame, SceneLight Light, LightPass Lights, IndirectPass Indirect, NativeRenderOptions Options,
    double[] RadianceFactors, double[] IndirectFactors, int Threads, CancellationToken Cancellation)
{
    /// <summary>Knows pieces of facets of which one point stands for all; null if nobody does.</summary>
    public IPieces? Pieces { get; init; }

    /// <summary>All samples of the lens; null if they are not known.</summary>
    public LensSubsamples? LensSamples { get; init; }
}
