using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Tracing;

namespace Msisf.Core.Render;

/// <summary>
/// Ground truth of a frame that another renderer draws. Each pixel is traced when it is requested. The light is a point. Safe for several
/// threads.
/// </summary>
public sealed class TracedFrameTruth : IGroundTruth
{
    private readonly ITerrainTracer _tracer;

    /// <summary>Prepares the ground truth of a frame.</summary>
    /// <param name="camera">The frame's camera, above the surface.</param>
    /// <param name="light">The Sun, or the lamp at the camera, which illuminates everything that the camera sees.</param>
    /// <param name="tracer">Traces rays on the surface.</param>
    public TracedFrameTruth(ICamera camera, SceneLight light, ITerrainTracer tracer)
    {
        Camera = camera;
        Light = light;
        _tracer = tracer;
    }

    /// <inheritdoc/>
    public ICamera Camera { get; }

    /// <inheritdoc/>
    public SceneLight Light { get; }

    /// <inheritdoc/>
    public ReadOnlySpan<double> RadianceFactors => [];

    /// <inheritdoc/>
    public bool TryGet(int x, int y, out SurfaceHit hit, out PixelIllumination light)
    {
        bool isSurface = _tracer.TryTrace(Camera.RayThrough(x, y), out hit);
        if (!isSurface)
        {
            light = default;
            return false;
        }

        // A lamp at the camera illuminates everything that the camera sees. It is not traced, because rounding on the way back could hide
        // the edges of facets.
        SceneLight source = Light.At(Camera, y);
        bool isDark = source.IsSun && _tracer.IsHidden(hit.PointBodyFixed, hit.Facet, source.PositionBodyFixed);
        light = PixelIllumination.At(hit.PointBodyFixed, isDark ? 0.0 : 1.0, source);
        return true;
    }
}
