using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.Core.Metadata;

/// <summary>Pixels on the reference sphere (thesis section 9.3). Immutable.</summary>
internal sealed class SpherePixels : IPixelView
{
    private readonly ICamera _camera;
    private readonly ISurface _sphere;
    private readonly SceneLight _light;

    /// <summary>Prepares a frame.</summary>
    /// <exception cref="BadInputException">The Sun's position is not finite.</exception>
    public SpherePixels(ICamera camera, ISurface sphere, SceneLight light)
    {
        if (!light.PositionBodyFixed.IsFinite)
        {
            throw new BadInputException($"The Sun's position {light.PositionBodyFixed} is not finite.");
        }

        _camera = camera;
        _sphere = sphere;
        _light = light;
    }

    public PixelSurface Surface => PixelSurface.Sphere;

    public bool TryGet(int h, int v, out PixelRecord record)
    {
        Ray ray = _camera.RayThrough(h, v);
        if (!_sphere.TryFirstHit(ray, out Vector3D point))
        {
            record = default;
            return false;
        }

        double? direction = IlluminationDirection.At(
            _camera.BandAt(v).Camera, ray.Direction, point, _light.At(_camera, v).PositionBodyFixed);
        record = new PixelRecord(h, v, SelenographicPoint.Below(point), direction);
        return true;
    }
}
