using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.Core.Attitude;

/// <summary>What must be known of Moon and Sun to place and point a camera; each is computed only where it is asked for.</summary>
public interface ISceneGeometry
{
    /// <summary>The body that is drawn.</summary>
    CelestialBody Body => CelestialBody.Moon;

    /// <summary>m: radius of the sphere over which heights are counted.</summary>
    double ReferenceRadius => MoonConstants.ReferenceRadius;

    /// <summary>Makes moments of dates.</summary>
    TimeScale TimeScale { get; }

    /// <summary>Distance from the Moon's centre to the terrain.</summary>
    /// <param name="directionBodyFixed">MOON_ME, any length but 0.</param>
    /// <returns>m.</returns>
    double GroundRadius(Vector3D directionBodyFixed);

    /// <summary>Position of the Sun.</summary>
    /// <returns>m, body-fixed.</returns>
    Vector3D SunPositionBodyFixed(Instant time);

    /// <summary>The rotation that turns J2000 components into body-fixed ones, MOON_ME of the Moon.</summary>
    /// <exception cref="Errors.SpiceException">The time is outside the kernels' cover, which the message names.</exception>
    RotationMatrix BodyFromJ2000(Instant time);
}
