using Msisf.Core.Attitude;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

using Msisf.Core.Surface.Sources;

namespace Msisf.TestSupport;

/// <summary>A smooth Moon some way over the reference sphere, and a Sun at a fixed place.</summary>
internal sealed class SphereScene : ISceneGeometry
{
    /// <summary>m over the reference radius.</summary>
    public const double TerrainHeight = 1234.5;

    /// <summary>m, MOON_ME.</summary>
    public static Vector3D Sun { get; } = new(1.2e11, -0.8e11, 0.3e11);

    public TimeScale TimeScale => Moments.Naif0012;

    public double GroundRadius(Vector3D directionBodyFixed) => MoonConstants.ReferenceRadius + TerrainHeight;

    public Vector3D SunPositionBodyFixed(Instant time) => Sun;

    /// <summary>Turns once in a day of 27.3: fast enough to show which time is meant.</summary>
    public RotationMatrix BodyFromJ2000(Instant time) =>
        RotationMatrix.FrameAboutZ(2.0 * Math.PI * time.Mjd / 27.3) * RotationMatrix.FrameAboutX(0.4);
}
