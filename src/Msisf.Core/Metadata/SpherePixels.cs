using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.Core.Metadata;

/// <summary>Pixels on the reference sphere (thesis section 9.3). Immutable.</summary>
internal sealed class SpherePixels : IPixelView
{
    private readonly PinholeCamera _camera;
    private readonly ISurface _sphere;
    private readonly Vector3D _sunPositionMoonMe;

    /// <summary>Prepares a frame.</summary>
    /// <exception cref="BadInputException">The Sun's position is not finite.</exception>
    public SpherePixels(PinholeCamera camera, ISurface sphere, Vector3D sunPositionMoonMe)
    {
        if (!sunPositionMoonMe.IsFinite)
        {
            throw new BadInputException($"The Sun's position {sunPositionMoonMe} is not finite.");
        }

        _camera = camera;
        _sphere = sphere;
        _sunPositionMoonMe = sunPositionMoonMe;
    }

    /// <inheritdoc/>
    public PixelSurface Surface => PixelSurface.Sphere;

    /// <inheritdoc/>
    public bool TryGet(int h, int v, out PixelRecord record)
    {
        Ray ray = _camera.RayThrough(h, v);
        if (!_sphere.TryFirstHit(ray, out Vector3D point))
        {
            record = default;
            return false;
        }

        double? direction = IlluminationDirection.At(_camera, ray.Direction, point, _sunPositionMoonMe);
        record = new PixelRecord(h, v, SelenographicPoint.Below(point), direction);
        return true;
    }
}
