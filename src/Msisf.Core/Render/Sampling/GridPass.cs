using Msisf.Core.Camera;
using Msisf.Core.Parallel;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;

namespace Msisf.Core.Render.Sampling;

/// <summary>
/// Draws frames with the same samples in each pixel, on a regular grid, where light and brightness follow from facet and Sun alone
/// (<see cref="LightPass.CanMerge"/>). The samples share the blocks of terrain and their projection, and where that is sure the light of
/// a facet. One object serves many frames, one at a time.
/// </summary>
/// <param name="pass">Finds the parts of pixels, their light and their brightness.</param>
internal sealed class GridPass(PartPass pass)
{
    /// <summary>Parts of pixels, or samples, that are lit and shaded together; bounds the memory.</summary>
    private const int PartsAtOnce = 1 << 18;

    /// <summary>Bands that are drawn between two looks at the number of parts.</summary>
    private const int BandsAtOnce = 2;

    private readonly SampledPixels _pixels = new();
    private readonly List<PixelParts> _parts = [];
    private readonly List<PixelParts> _samples = [];

    /// <summary>Draws a frame.</summary>
    /// <param name="frame">The frame, prepared or drawn with one sample a pixel at the pixels' centres.</param>
    /// <param name="light">The Sun.</param>
    /// <param name="lights">Finds light and brightness.</param>
    /// <param name="options">The settings.</param>
    /// <param name="radianceFactors">Receives the brightness of the pixels.</param>
    /// <param name="threads">Maximum number of threads; the result does not depend on it.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void Run(
        VisibilityPass frame, SceneLight light, LightPass lights, NativeRenderOptions options, double[] radianceFactors, int threads,
        CancellationToken cancellation)
    {
        FrameCamera camera = frame.View.Camera;
        Array.Clear(radianceFactors, 0, camera.Width * camera.Height);
        _pixels.TakeAll(camera.Width, camera.Height, SamplePattern.OfGrid(options.SubsamplesPerAxis));
        SampledFrame sampled = new(frame, _pixels, light, lights, options, radianceFactors, threads, cancellation);
        int bands = _pixels.Bands.Count;
        for (int first = 0, end; first < bands; first = end)
        {
            end = first;
            for (int parts = 0; end < bands && parts < PartsAtOnce;)
            {
                int next = Math.Min(end + BandsAtOnce, bands);
                pass.Find(sampled, (end, next), _parts, end - first);
                for (; end < next; end++)
                {
                    parts += _parts[end - first].Count;
                }
            }

            Light(sampled, end - first);
        }
    }

    /// <summary>Lights and shades the samples on a facet of a pixel at once where that is sure, and each by itself elsewhere.</summary>
    private void Light(SampledFrame frame, int count)
    {
        double[] factors = pass.Lay(frame, _parts, count);
        frame.Lights.RunMerged(pass.Rows, frame.Light, frame.Options, pass.Sunlight, factors, frame.Threads, frame.Cancellation);
        Collect(frame, _parts, count);
        byte[][] states = [.. Enumerable.Range(0, count).Select(list => pass.StatesOf(list, _parts[list]).ToArray())];
        for (int first = 0, end; first < count; first = end)
        {
            end = first;
            for (int samples = 0; end < count && samples < PartsAtOnce; end++)
            {
                samples += _parts[end].CountSamples(states[end], ShadowPass.Unsure);
            }

            PartPass.EnsureRoom(_samples, end - first);
            WorkerTeam.Run(
                frame.Threads,
                end - first,
                (_, index) => _samples[index].TakeSamples(
                    _parts[first + index], states[first + index], ShadowPass.Unsure, frame.Pixels.Grid!, frame.Frame.View),
                frame.Cancellation);
            pass.Light(frame, _samples, end - first);
            Collect(frame, _samples, end - first);
        }
    }

    private void Collect(SampledFrame frame, List<PixelParts> lists, int count) =>
        WorkerTeam.Run(frame.Threads, count, (_, list) => pass.Collect(frame, list, lists[list]), frame.Cancellation);
}
