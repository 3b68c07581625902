using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Stress.Camera;
using Msisf.Stress.Reference;

namespace Msisf.Stress.Metadata;

/// <summary>Draws a pixel that shows the Moon, and the light.</summary>
/// <param name="random">Draws.</param>
internal sealed class PixelCases(CaseRandom random)
{
    /// <summary>m: the highest camera.</summary>
    public const double Highest = 1e12;

    private const double SunDistance = 1.496e11;

    private readonly AimedCameras _cameras = new(random);

    /// <summary>Evenly over the disc; one in eight close to the limb.</summary>
    /// <param name="number">Of the case: kinds take turns.</param>
    public CameraInput Camera(int number)
    {
        Vector3D position = (MoonConstants.ReferenceRadius + random.Logarithmic(1.0, Highest)) * _cameras.Zenith(number);
        double share = number / 8 % 8 == 0 ? 1.0 - random.Logarithmic(1e-14, 1e-2) : Math.Sqrt(random.Between(0.0, 1.0));
        return _cameras.Passing(position, share * MoonConstants.ReferenceRadius);
    }

    /// <summary>The Sun anywhere, near the zenith or nadir of the pixel's point, low over it, or a light at the camera.</summary>
    public Vector3D Light(int number, CameraInput input, PrecisePixel? pixel)
    {
        Vector3D zenith = (pixel?.Point.Rounded ?? input.Position).Normalized();
        return (number / 3 % 8) switch
        {
            0 => SunDistance * Near(zenith, random.Logarithmic(1e-8, 1e-1)),
            1 => SunDistance * Near(-zenith, random.Logarithmic(1e-8, 1e-1)),
            2 => SunDistance * Near(Vector3D.Cross(zenith, random.Direction()).Normalized(), random.Logarithmic(1e-8, 1e-1)),
            3 => input.Position,
            _ => SunDistance * random.Direction(),
        };
    }

    private Vector3D Near(Vector3D direction, double angle) => (direction + (angle * random.Direction())).Normalized();
}
