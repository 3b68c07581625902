using Msisf.App.Preparation;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.App.Serving;

/// <summary>Follows single rays of a frame on the surface that it shows. The Sun is a point. Thread-safe.</summary>
/// <param name="frame">The frame.</param>
/// <param name="surface">Traces rays on the surface, and its px/deg.</param>
internal sealed class FrameTruth(Frame frame, (ITerrainTracer Tracer, int PixelsPerDegree) surface)
{
    /// <summary>m: how far from a point of the surface a ray towards it may end; the rounding of its way from the camera is less.</summary>
    private const double SamePoint = 1e-3;

    /// <summary>px/deg of the surface.</summary>
    public int PixelsPerDegree => surface.PixelsPerDegree;

    /// <summary>The camera.</summary>
    public PinholeCamera Camera => frame.Camera;

    /// <summary>The Sun, or the lamp at the camera, m, MOON_ME.</summary>
    public Vector3D LightPositionMoonMe => frame.Light.PositionMoonMe;

    /// <summary>The point of the surface that a point of the image shows.</summary>
    /// <param name="x">Pixels from 1, to the right; need not be whole.</param>
    /// <param name="y">Pixels from 1, down.</param>
    /// <param name="hit">The point.</param>
    /// <param name="light">How it is lit.</param>
    /// <returns>Whether the Moon is seen there.</returns>
    public bool TryPixel(double x, double y, out SurfaceHit hit, out PixelIllumination light)
    {
        if (!surface.Tracer.TryTrace(frame.Camera.RayThrough(x, y), out hit))
        {
            light = default;
            return false;
        }

        light = LightAt(hit);
        return true;
    }

    /// <summary>The point of the surface above or below a place.</summary>
    /// <param name="direction">From the Moon's centre.</param>
    /// <param name="hit">The point.</param>
    public bool TryPlace(Vector3D direction, out SurfaceHit hit)
    {
        const double outside = 1.01; // over the highest point of the Moon
        Vector3D start = outside * MoonConstants.ReferenceRadius * direction.Normalized();
        return surface.Tracer.TryTrace(new Ray(start, -1.0 * direction.Normalized()), out hit);
    }

    /// <summary>How a point of the surface is lit.</summary>
    public PixelIllumination LightAt(SurfaceHit hit)
    {
        bool isDark = frame.Light.IsSun && surface.Tracer.IsHidden(hit.PointMoonMe, hit.Facet, frame.Light.PositionMoonMe);
        return PixelIllumination.At(hit.PointMoonMe, isDark ? 0.0 : 1.0, frame.Light);
    }

    /// <summary>Whether nothing lies between the camera and a point on or over the surface.</summary>
    public bool IsVisible(Vector3D pointMoonMe)
    {
        Vector3D way = pointMoonMe - frame.Camera.PositionMoonMe;
        return !surface.Tracer.TryTrace(new Ray(frame.Camera.PositionMoonMe, way), out SurfaceHit hit)
            || hit.RayParameter * way.Length > way.Length - SamePoint;
    }
}
