using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.TestSupport;

/// <summary>
/// A smooth sphere in place of the terrain: every layer of it is known in closed form. Lit by day, night beyond the terminator.
/// </summary>
internal sealed class SphereTruth(
    ICamera camera, Vector3D lightPositionBodyFixed, int pixelsPerDegree, double radius = 1_737_400.0) : IGroundTruth
{
    private readonly ReferenceSphere _sphere = new(radius);

    public ICamera Camera => camera;

    public int RowsAtOnce { get; init; } = camera.Height;

    public SceneLight Light => new(lightPositionBodyFixed, IsSun: true);

    public ReadOnlySpan<double> RadianceFactors => [];

    public bool TryGet(int x, int y, out SurfaceHit hit, out PixelIllumination light)
    {
        Ray ray = camera.RayThrough(x, y);
        if (!_sphere.TryFirstHit(ray, out Vector3D point))
        {
            hit = default;
            light = default;
            return false;
        }

        Vector3D normal = point.Normalized();
        double parameter = Vector3D.Dot(point - ray.Origin, ray.Direction) / ray.Direction.LengthSquared;
        hit = new SurfaceHit(point, normal, FacetBelow(point), parameter);
        bool isDay = Vector3D.Dot(normal, lightPositionBodyFixed - point) > 0.0;
        light = isDay ? new PixelIllumination(IlluminationState.Lit, 1.0) : new PixelIllumination(IlluminationState.Night, 0.0);
        return true;
    }

    private FacetId FacetBelow(Vector3D point)
    {
        SelenographicPoint below = SelenographicPoint.Below(point);
        int line = (int)Math.Floor(((90.0 - double.RadiansToDegrees(below.Latitude)) * pixelsPerDegree) - 0.5);
        int sample = (int)Math.Floor((double.RadiansToDegrees(below.Longitude) * pixelsPerDegree) - 0.5);
        int samples = 360 * pixelsPerDegree;
        return new FacetId(line, (sample + samples) % samples, FacetHalf.SouthWest);
    }
}
