using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Tracing;

namespace Msisf.Core.Render;

/// <summary>
/// The truth of a frame that another renderer draws: each pixel is traced when it is asked for. The light is a point. Safe for several
/// threads.
/// </summary>
public sealed class TracedFrameTruth : IGroundTruth
{
    private readonly SceneLight _light;
    private readonly ITerrainTracer _tracer;

    /// <summary>Prepares a frame.</summary>
    /// <param name="camera">The frame's camera, above the surface.</param>
    /// <param name="light">The Sun, or the lamp at the camera, which lights all that is seen.</param>
    /// <param name="tracer">Knows the surface.</param>
    public TracedFrameTruth(PinholeCamera camera, SceneLight light, ITerrainTracer tracer)
    {
        Camera = camera;
        _light = light;
        _tracer = tracer;
    }

    /// <inheritdoc/>
    public PinholeCamera Camera { get; }

    /// <inheritdoc/>
    public Vector3D LightPositionMoonMe => _light.PositionMoonMe;

    /// <inheritdoc/>
    public bool TryGet(int x, int y, out SurfaceHit hit, out PixelIllumination light)
    {
        bool isSurface = _tracer.TryTrace(Camera.RayThrough(x, y), out hit);
        if (!isSurface)
        {
            light = default;
            return false;
        }

        // A lamp at the camera lights what the camera sees; traced back, rounding could hide the edges of facets.
        bool isDark = _light.IsSun && _tracer.IsHidden(hit.PointMoonMe, hit.Facet, _light.PositionMoonMe);
        light = PixelIllumination.At(hit.PointMoonMe, isDark ? 0.0 : 1.0, _light);
        return true;
    }
}
