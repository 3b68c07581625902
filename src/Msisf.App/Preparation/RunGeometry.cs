using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>Terrain and Sun of a run, each opened only where a camera is placed or pointed by it.</summary>
/// <param name="model">Opens the elevation model, or returns the open one.</param>
/// <param name="ephemeris">Opens the ephemeris, or returns the open one.</param>
/// <param name="aberration">Which effects of light's finite speed the Sun's position includes, as for the run's light.</param>
/// <param name="body">The body; null for the Moon.</param>
internal sealed class RunGeometry(
    Func<ElevationModel> model, Func<IEphemeris> ephemeris, Aberration aberration, CelestialBody? body = null) : ISceneGeometry
{
    public double ReferenceRadius => body is { IsMoon: false } ? model().Grid.ReferenceRadius : MoonConstants.ReferenceRadius;

    public double GroundRadius(Vector3D directionBodyFixed) => model().GroundRadius(directionBodyFixed);

    public Vector3D SunPositionBodyFixed(ModifiedJulianDate time) => ephemeris().SunPositionBodyFixed(time, aberration);

    public RotationMatrix MoonMeFromJ2000(ModifiedJulianDate time) => ephemeris().MoonMeFromJ2000(time);
}
