using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.Benchmarks.Fronts;

/// <summary>Random pixels of an image, and the points of the full model that their centres show by the exact tracer.</summary>
internal sealed class HitPixels
{
    private const int Seed = 20120222;
    private const int Count = 1000;

    private readonly PinholeCamera _camera;
    private readonly (int X, int Y)[] _pixels;

    /// <summary>Takes the pixels and traces them.</summary>
    /// <param name="camera">Of the image.</param>
    /// <param name="model">The full model.</param>
    public HitPixels(PinholeCamera camera, IGlobalGrid model)
    {
        _camera = camera;
        Random random = new(Seed);
        _pixels = [.. Enumerable.Range(0, Count).Select(_ => (random.Next(1, camera.Width + 1), random.Next(1, camera.Height + 1)))];
        TerrainTracer tracer = new(model);
        Truth = [.. Rays.Select(ray => tracer.TryFirstHit(ray, out Vector3D point) ? point : (Vector3D?)null)];
    }

    /// <summary>m, MOON_ME; null where a pixel shows no surface.</summary>
    public IReadOnlyList<Vector3D?> Truth { get; }

    /// <summary>Through the pixels' centres.</summary>
    public IEnumerable<Ray> Rays => _pixels.Select(pixel => _camera.RayThrough(pixel.X, pixel.Y));

    /// <summary>The points that the native renderer shows.</summary>
    /// <param name="drawn">The level of the model that it draws.</param>
    public IReadOnlyList<Vector3D?> ByNative(IGlobalGrid drawn)
    {
        NativeRenderOptions options = new() { Reflectance = new EvenReflectance(), KeepGroundTruth = true };
        SceneLight lamp = new(_camera.PositionBodyFixed, IsSun: false);
        using NativeFrame frame = new NativeRenderer(drawn).Render(
            _camera, lamp, options, Environment.ProcessorCount, CancellationToken.None);
        return [.. _pixels.Select(pixel => frame.TryGet(pixel.X, pixel.Y, out SurfaceHit hit, out _) ? hit.PointBodyFixed
            : (Vector3D?)null)];
    }
}
