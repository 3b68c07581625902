using Msisf.Core.Camera;
using Msisf.Core.Render.Indirect;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Sampling;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Tracing;

namespace Msisf.Core.Render;

/// <summary>
/// Draws frames one at a time: for each sample of a pixel it finds the surface point, the sunlight on it and its brightness. It keeps its
/// memory from frame to frame. A finished frame may be read by several threads.
/// </summary>
internal sealed class FramePass : IDrawnFrame
{
    private readonly VisibilityPass _visibility;
    private readonly LightPass _light;
    private readonly PartPass _parts;
    private readonly SamplingPass _sampling;
    private readonly IndirectPass _indirect;
    private VisibleSurface? _visible;
    private readonly PixelSunlight _sunlight = new();
    private double[] _radianceFactors = [];
    private double[] _indirectFactors = [];
    private NativeRenderOptions? _options;

    /// <param name="surface">The surface that is drawn.</param>
    /// <param name="lenses">Samples of lenses that other frames use too.</param>
    public FramePass(SurfaceModel surface, LensCache lenses)
    {
        Shown = surface;
        _visibility = new VisibilityPass(surface, lenses);
        _light = new LightPass(surface);
        _parts = new PartPass(surface);
        _sampling = new SamplingPass(_parts);
        _indirect = new IndirectPass(surface);
    }

    /// <summary>The surface that is drawn.</summary>
    public SurfaceModel Shown { get; private set; }

    /// <summary>Camera of the last frame.</summary>
    public FrameCamera Camera { get; private set; } = null!;

    ICamera IDrawnFrame.Camera => Camera;

    /// <summary>Light of the last frame.</summary>
    public SceneLight Light { get; private set; }

    /// <summary>Radiance factor I/F of each pixel, row by row from the top.</summary>
    public Memory<double> RadianceFactors => _radianceFactors.AsMemory(0, Camera.Width * Camera.Height);

    /// <summary>The part of <see cref="RadianceFactors"/> that the ground's own light makes; empty if it is not asked for.</summary>
    public ReadOnlyMemory<double> IndirectFactors =>
        _indirectFactors.AsMemory(0, _options?.Indirect is null ? 0 : Camera.Width * Camera.Height);

    /// <summary>Pixels of the largest frame so far.</summary>
    public long Capacity => _radianceFactors.Length;

    /// <summary>Bytes of the buffers that have been replaced by smaller or larger ones since the first frame.</summary>
    public long ReplacedBytes => _visibility.Surface.ReplacedBytes + _light.ReplacedBytes;

    /// <summary>Draws another surface from the next frame on, with the memory of the frames before.</summary>
    public void Show(SurfaceModel surface)
    {
        Shown = surface;
        _visible = null;
        _visibility.Show(surface);
        _light.Show(surface);
        _parts.Show(surface);
        _indirect.Show(surface);
    }

    public void Draw(FrameCamera camera, SceneLight light, NativeRenderOptions options, int threads, CancellationToken cancellation)
    {
        (Camera, Light, _options) = (camera, light, options);
        int pixels = camera.Width * camera.Height;
        if (_radianceFactors.Length < pixels)
        {
            _radianceFactors = new double[pixels];
        }

        if (options.Indirect is not null)
        {
            _indirectFactors = new double[pixels];
        }

        bool isOfCentres = options.SubsamplesPerAxis == 1;
        if (isOfCentres || options.KeepGroundTruth || options.Indirect is not null)
        {
            DrawCentres(isOfCentres, threads, cancellation);
        }
        else
        {
            _visibility.Prepare(camera, threads, cancellation);
        }

        SampledFrame work = new(
            _visibility, light, _light, _indirect, options, _radianceFactors, options.Indirect is null ? [] : _indirectFactors, threads,
            cancellation);
        if (options.Adaptive is { } adaptive)
        {
            _sampling.Run(work, adaptive, _sunlight);
        }
        else if (!isOfCentres)
        {
            _sampling.Run(work, SamplePattern.Grid(options.SubsamplesPerAxis));
        }

        if (options.Indirect is not null)
        {
            _indirect.End();
        }
    }

    /// <summary>Gets the surface point at a pixel's centre and its illumination.</summary>
    public bool TryGet(int x, int y, out SurfaceHit hit, out PixelIllumination light)
    {
        if (!TryGetSurface(x, y, out hit))
        {
            light = default;
            return false;
        }

        light = PixelIllumination.At(hit.PointBodyFixed, _sunlight.VisibleFraction(((y - 1) * Camera.Width) + x - 1), Light);
        if (_options!.Normals == NormalModel.Smooth)
        {
            hit = hit with { NormalBodyFixed = _light.SmoothNormal(hit, Camera.PositionBodyFixed) };
        }

        return true;
    }

    /// <summary>Gets the surface points at the pixels' centres of a row and their illumination.</summary>
    public void ReadRow(int y, TruthRow row)
    {
        VisibleSurface visible = KeptSurface();
        row.Clear(visible.Width);
        SurfaceRow points = row.Points;
        visible.Read(y, points);
        visible.ReadFacets(y, points, row.Facets);
        int start = (y - 1) * visible.Width;
        for (int i = 0; i < points.Count; i++)
        {
            Vector3D point = new(points.X[i], points.Y[i], points.Z[i]);
            row.Lights[i] = PixelIllumination.At(point, _sunlight.VisibleFraction(start + points.Columns[i]), Light);
            if (_options!.Normals == NormalModel.Smooth)
            {
                Vector3D ofFacet = new(points.NormalX[i], points.NormalY[i], points.NormalZ[i]);
                Vector3D normal = _light.SmoothNormal(
                    new SurfaceHit(point, ofFacet, row.Facets[i], points.Parameters[i]), Camera.PositionBodyFixed);
                (points.NormalX[i], points.NormalY[i], points.NormalZ[i]) = (normal.X, normal.Y, normal.Z);
            }
        }
    }

    /// <summary>Gets the surface point at a pixel's centre, with its facet's normal.</summary>
    public bool TryGetSurface(int x, int y, out SurfaceHit hit) => KeptSurface().TryGet(x, y, out hit);

    /// <summary>Draws one sample a pixel, at its centre.</summary>
    /// <param name="isShaded">Whether the pixels get its brightness, or only what it shows and its light is found.</param>
    private void DrawCentres(bool isShaded, int threads, CancellationToken cancellation)
    {
        _visible = _visibility.Run(Camera, threads, cancellation);
        if (isShaded)
        {
            bool forgetsLight = _options is { KeepGroundTruth: false, Adaptive: null };
            _light.Run(_visible, Light, _options!, forgetsLight, _sunlight, _radianceFactors, threads, cancellation);
        }
        else
        {
            _light.FindLight(_visible, Light, _options!, _sunlight, scales: [], threads, cancellation);
        }

        if (_options!.Indirect is null)
        {
            return;
        }

        _indirect.Begin(_visible, Light, _options, threads, cancellation);
        if (isShaded)
        {
            _indirect.Add(_visible, _options, _radianceFactors, _indirectFactors, threads, cancellation);
        }
    }

    private VisibleSurface KeptSurface() => _options is { KeepGroundTruth: true } && _visible is not null
        ? _visible
        : throw new InvalidOperationException($"The frame was drawn without {nameof(NativeRenderOptions.KeepGroundTruth)}.");

}
