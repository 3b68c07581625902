using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Tracing;

namespace Msisf.Core.Illumination;

/// <summary>Decides by rays of the exact tracer whether any part of the Sun is in view. Safe for several threads.</summary>
/// <param name="tracer">The tracer.</param>
/// <param name="sunBodyFixed">The Sun at each step, m, body-fixed.</param>
/// <param name="sunRadius">m; 0 for a point.</param>
internal sealed class ExactLight(ITerrainTracer tracer, IReadOnlyList<Vector3D> sunBodyFixed, double sunRadius)
{
    /// <summary>rad, 0.01 degrees: where the horizon is nearer to the Sun's edge, rays decide. It is twice the horizon's error.</summary>
    public const float Doubt = 1.75e-4f;

    /// <summary>Points of the upper half of the Sun's edge: what is seen first and last lies on the edge.</summary>
    public const int EdgePoints = 2048;

    /// <summary>Whether any part of the Sun is in view of a place above the ground.</summary>
    /// <param name="frame">The place.</param>
    /// <param name="step">The step.</param>
    public bool IsVisible(LocalFrame frame, int step) => IsVisible(frame, sunBodyFixed[step]);

    /// <summary>The same for a place of the Sun, m, body-fixed.</summary>
    public bool IsVisible(LocalFrame frame, Vector3D sun)
    {
        Vector3D toSun = sun - frame.PositionBodyFixed;
        if (sunRadius == 0.0)
        {
            return !tracer.TryTrace(new Ray(frame.PositionBodyFixed, toSun), out _);
        }

        // Rays to the upper edge, the steepest first: mostly the first one that is free is near.
        Vector3D across = Vector3D.Cross(toSun, frame.Up).Normalized();
        Vector3D up = Vector3D.Cross(across, toSun).Normalized();
        double distance = toSun.Length;
        double radius = distance * sunRadius / Math.Sqrt((distance - sunRadius) * (distance + sunRadius));
        for (int stride = EdgePoints; stride >= 1; stride /= 2)
        {
            for (int point = stride == EdgePoints ? EdgePoints / 2 : stride / 2; point <= EdgePoints; point += stride)
            {
                (double sine, double cosine) = Math.SinCos(Math.PI * point / EdgePoints);
                Vector3D edge = toSun + (radius * ((cosine * across) + (sine * up)));
                if (!tracer.TryTrace(new Ray(frame.PositionBodyFixed, edge), out _))
                {
                    return true;
                }
            }
        }

        return false;
    }
}
