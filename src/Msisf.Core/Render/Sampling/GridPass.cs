using Msisf.Core.Camera;
using Msisf.Core.Parallel;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Sampling;

/// <summary>
/// Draws frames with the same samples in each pixel, on a regular grid, where the brightness of lit ground follows from facet and Sun
/// alone. The samples share the blocks of terrain and their projection, the brightness of a facet and, where that is sure, its light. One
/// object serves many frames, one at a time.
/// </summary>
/// <param name="pass">Finds the light and brightness of the other samples.</param>
internal sealed class GridPass(PartPass pass)
{
    /// <summary>Samples that are lit and shaded together; bounds the memory.</summary>
    private const int SamplesAtOnce = 1 << 17;

    /// <summary>Samples of the rows that are drawn together: their depth buffer has 1.5 MB.</summary>
    private const int SamplesOfBand = 1 << 17;

    /// <summary>Bands that each thread draws between two looks at the number of samples.</summary>
    private const int BandsAtOnce = 2;

    private readonly List<GridWorker> _workers = [];
    private readonly List<PixelParts> _others = []; // of each worker

    /// <summary>Facets for each pixel above which two samples along its edge have too little to share.</summary>
    private const double FewFacets = 2.0;

    /// <summary>Whether frames are drawn so: by a pinhole, with several samples that have something to share.</summary>
    /// <param name="light">The Sun, or the lamp at the camera.</param>
    /// <param name="lights">Finds light and brightness.</param>
    /// <param name="options">The settings.</param>
    /// <param name="blocks">Number of blocks that the frame may show.</param>
    public static bool Suits(FrameCamera camera, SceneLight light, LightPass lights, NativeRenderOptions options, int blocks) =>
        options.SubsamplesPerAxis is > 1 and <= GridWorker.MaxAcross && camera.Model.Lens is null
        && lights.IsOfFacets(light, options)
        && (options.SubsamplesPerAxis > 2
            || 2.0 * blocks * CellBlock.Size * CellBlock.Size < FewFacets * camera.Width * camera.Height);

    /// <summary>Draws a frame.</summary>
    /// <param name="frame">The frame, prepared or drawn with one sample a pixel at the pixels' centres.</param>
    /// <param name="light">The Sun.</param>
    /// <param name="lights">Finds light and brightness.</param>
    /// <param name="options">The settings.</param>
    /// <param name="radianceFactors">Receives the brightness of the pixels.</param>
    /// <param name="threads">Maximum number of threads; the result does not depend on it.</param>
    public void Run(
        SurfaceModel surface, VisibilityPass frame, SceneLight light, LightPass lights, NativeRenderOptions options,
        double[] radianceFactors, int threads, CancellationToken cancellation)
    {
        FrameCamera camera = frame.View.Camera;
        int across = options.SubsamplesPerAxis;
        int bins = Math.Clamp((int)Math.Sqrt((double)camera.Width * camera.Height), 1, 2048);
        GridFrame grid = new(
            surface, frame.Blocks, new ImageView(camera, 0.0, 0.0, perAxis: across),
            lights.FindCasters(frame.Blocks.Select(visible => visible.Block), light, bins, threads, cancellation), light.PositionBodyFixed,
            options, radianceFactors);
        SampledFrame sampled = new(frame, light, lights, Indirect: null, options, radianceFactors, threads, cancellation);
        PartPass.EnsureRoom(_others, threads);
        while (_workers.Count < threads)
        {
            _workers.Add(new GridWorker());
        }

        int rows = Math.Clamp(SamplesOfBand / (across * across * camera.Width), 1, VisibleSurface.BandRows);
        for (int first = 0; first < camera.Height;)
        {
            _others.ForEach(parts => parts.Begin());
            while (first < camera.Height && _others.Sum(parts => parts.Count) < SamplesAtOnce)
            {
                int begin = first;
                first = Math.Min(first + (BandsAtOnce * threads * rows), camera.Height);
                WorkerTeam.Run(
                    threads,
                    (first - begin + rows - 1) / rows,
                    (worker, band) => _workers[worker].Draw(
                        grid, begin + (band * rows), Math.Min(rows, camera.Height - begin - (band * rows)), _others[worker]),
                    cancellation);
            }

            pass.Light(sampled, _others, threads);
            WorkerTeam.Run(threads, threads, (_, list) => pass.Collect(sampled, list, _others[list]), cancellation);
        }
    }
}
