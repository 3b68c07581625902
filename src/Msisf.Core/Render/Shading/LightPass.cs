using Msisf.Core.Parallel;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Tracing;

namespace Msisf.Core.Render.Shading;

/// <summary>
/// Finds the light on surface points and their brightness. One object serves many frames, one at a time, and keeps its memory.
/// </summary>
internal sealed class LightPass
{
    private readonly ShadowPass _shadows;
    private readonly PenumbraPass _penumbras;
    private readonly DiscShader _discShader = new();
    private readonly RowShader _shader;

    /// <summary>Makes a pass for a model.</summary>
    public LightPass(SurfaceModel surface)
    {
        _shadows = new ShadowPass(surface);
        _penumbras = new PenumbraPass(surface);
        _shader = new RowShader(surface);
    }

    /// <summary>Lights another surface from the next frame on; the memory is kept.</summary>
    public void Show(SurfaceModel surface)
    {
        _shadows.Show(surface);
        _penumbras.Show(surface);
        _shader.Show(surface);
    }

    /// <summary>Bytes of the arrays of receivers that have been replaced since the first frame.</summary>
    public long ReplacedBytes => _shadows.ReplacedBytes + _penumbras.ReplacedBytes;

    /// <summary>Finds the light on points and their brightness.</summary>
    /// <param name="light">The Sun, or the lamp at the camera.</param>
    /// <param name="options">Reflectance law, Sun and kind of normals.</param>
    /// <param name="forgetsLight">Whether nobody reads the cosines afterwards: they then need no memory beside that of the image.</param>
    /// <param name="sunlight">Receives the light on each point.</param>
    /// <param name="radianceFactors">Receives the radiance factors (I/F), row by row.</param>
    public void Run(
        ISurfaceRows points, SceneLight light, NativeRenderOptions options, bool forgetsLight, PixelSunlight sunlight,
        double[] radianceFactors, int threads, CancellationToken cancellation)
    {
        sunlight.Prepare(points.Width * points.Height, HasDisc(light, options), forgetsLight ? radianceFactors : null);
        bool reflectsFirst = _shader.ReflectsFirst(options, HasDisc(light, options));
        if (reflectsFirst)
        {
            _shader.Prepare(points.Width * points.Height);
        }

        FindLight(
            points, light, options, sunlight,
            reflectsFirst ? (row, pixels, cosines) => _shader.Reflect(points, light, options, row, pixels, cosines) : null,
            threads, cancellation);
        Shade(points, light, options, sunlight, scales: [], radianceFactors, threads, cancellation);
    }

    /// <summary>Finds the light on points; the other parameters are those of <see cref="Run"/>.</summary>
    /// <param name="scales">
    /// Receives by what maps multiply the law's radiance factors where there is light, row by row; empty if nobody asks.
    /// </param>
    public void FindLight(
        ISurfaceRows points, SceneLight light, NativeRenderOptions options, PixelSunlight sunlight, double[] scales, int threads,
        CancellationToken cancellation)
    {
        sunlight.Prepare(points.Width * points.Height, HasDisc(light, options));
        double minCosine = HasDisc(light, options) ? new SunDisc(light.PositionBodyFixed, light.Radius).MinCosine : 0.0;
        FindLight(
            points, light, options, sunlight,
            scales.Length == 0 ? null : (row, pixels, cosines) => _shader.FindScales(
                points.View.Camera, pixels, cosines, minCosine, options, scales.AsSpan(row * points.Width, points.Width)),
            threads, cancellation);
    }

    /// <summary>Finds the brightness of points whose light is known; the other parameters are those of <see cref="Run"/>.</summary>
    /// <param name="scales">By what maps multiply the law's radiance factors; empty to read the maps.</param>
    public void Shade(
        ISurfaceRows points, SceneLight light, NativeRenderOptions options, PixelSunlight sunlight,
        double[] scales, double[] radianceFactors, int threads, CancellationToken cancellation) =>
        _shader.Shade(points, light, sunlight, options, scales, radianceFactors, threads, cancellation);

    /// <inheritdoc cref="RowShader.HasMap"/>
    public bool HasMap(NativeRenderOptions options) => _shader.HasMap(options);

    /// <inheritdoc cref="RowShader.HasRays"/>
    public bool HasRays => _shader.HasRays;

    /// <summary>Prepares to tell the light on pieces of facets; null for a light that throws no shadows.</summary>
    /// <param name="blocks">The blocks in which the facets lie.</param>
    public SureLight? FindSureLight(
        IEnumerable<CellBlock> blocks, SceneLight light, NativeRenderOptions options, int threads, CancellationToken cancellation) =>
        light.IsSun
            ? _shadows.FindCasters(
                blocks, light.PositionBodyFixed,
                HasDisc(light, options) ? new SunDisc(light.PositionBodyFixed, light.Radius).Slope : 0.0, threads, cancellation)
            : null;

    /// <summary>The smooth normal at a point, as it is used for shading; length 1, body-fixed, or the facet's normal.</summary>
    /// <param name="hit">The point, with its facet's normal.</param>
    /// <param name="cameraBodyFixed">The camera's position, m, body-fixed.</param>
    public Vector3D SmoothNormal(SurfaceHit hit, Vector3D cameraBodyFixed) => _shader.SmoothNormal(hit, cameraBodyFixed);

    private static bool HasDisc(SceneLight light, NativeRenderOptions options) => light.IsSun && options.Sun == SunModel.Disc;

    private void FindLight(
        ISurfaceRows points, SceneLight light, NativeRenderOptions options, PixelSunlight sunlight,
        Action<int, SurfaceRow, double[]>? rowRead, int threads, CancellationToken cancellation)
    {
        if (HasDisc(light, options))
        {
            SunDisc disc = new(light.PositionBodyFixed, light.Radius);
            SunwardPoints facing = new(points, light.PositionBodyFixed, sunlight.CosIncidence, disc.MinCosine) { RowRead = rowRead };
            _penumbras.Run(facing, disc, sunlight.HiddenPoints, threads, cancellation);
            _discShader.Run(points, disc, sunlight, threads, cancellation);
            return;
        }

        SunwardPoints sunward = new(points, light.PositionBodyFixed, sunlight.CosIncidence) { RowRead = rowRead };
        if (light.IsSun)
        {
            _shadows.Run(sunward, light.PositionBodyFixed, sunlight.Hidden, threads, cancellation);
        }
        else
        {
            sunlight.Hidden.AsSpan(0, points.Width * points.Height).Clear();
            WorkerTeam.Run(threads, sunward.Rows, (_, row) => sunward.ReadCosines(row), cancellation);
        }
    }
}
