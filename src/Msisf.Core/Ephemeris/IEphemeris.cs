using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>
/// Gives the Sun's position and the orientation of the body's frame, which for the Moon is MOON_ME; every ephemeris engine implements it.
/// "Moon" in its names stands for the body that is drawn. Safe for several threads.
/// </summary>
public interface IEphemeris
{
    /// <summary>Name and version of the engine for the run's log, e.g. "CSPICE N0067".</summary>
    string EngineName { get; }

    /// <summary>Position of the Sun relative to the Moon's centre.</summary>
    /// <param name="time">When the light arrives at the Moon.</param>
    /// <param name="aberration">Which effects of light's finite speed are included.</param>
    /// <returns>m, in MOON_ME at <paramref name="time"/>, with or without light time.</returns>
    /// <exception cref="SpiceException">
    /// The time, or with light time the time when the light left the Sun, is outside the kernels' cover, which the message names.
    /// </exception>
    Vector3D SunPositionBodyFixed(Instant time, Aberration aberration = Aberration.None);

    /// <summary>The scale of the kernels' leap seconds, which makes moments of dates.</summary>
    TimeScale TimeScale { get; }

    /// <summary>The rotation that turns J2000 components into body-fixed ones, MOON_ME of the Moon.</summary>
    /// <exception cref="SpiceException">The time is outside the kernels' cover, which the message names.</exception>
    RotationMatrix BodyFromJ2000(TdbTime time);

    /// <summary>How fast the body's frame turns: rad/s relative to J2000, along J2000's axes.</summary>
    /// <exception cref="SpiceException">The time is outside the kernels' cover, which the message names.</exception>
    Vector3D BodyRateJ2000(TdbTime time);

    /// <summary>Where another body is, light time left out.</summary>
    /// <param name="naifNumber">NAIF's number of the body, e.g. 399 for the Earth.</param>
    /// <returns>Position (m) and velocity (m/s) relative to the Moon's centre, J2000.</returns>
    /// <exception cref="SpiceException">No kernel has that body at that time.</exception>
    StateVector StateOf(int naifNumber, TdbTime time);
}

/// <summary>Which effects of light's finite speed the Sun's position includes; the values are those of SPICE.</summary>
public enum Aberration
{
    /// <summary>None: where the Sun is at the time (SPICE "NONE"; the thesis).</summary>
    None,

    /// <summary>Light time: where the Sun was when it sent the light that arrives at the time (SPICE "LT", one iteration).</summary>
    LightTime,

    /// <summary>Light time, and the direction from which the moving Moon sees the light come (SPICE "LT+S").</summary>
    LightTimeAndStellar,
}

/// <summary>
/// Position and velocity relative to a body's centre, in the frame that its user names; <c>default</c> is at rest at the centre.
/// </summary>
/// <param name="Position">m; within kernels km.</param>
/// <param name="Velocity">m/s; within kernels km/s.</param>
public readonly record struct StateVector(Vector3D Position, Vector3D Velocity)
{
    /// <summary>Adds, so that a chain of centres becomes one state.</summary>
    public static StateVector operator +(StateVector a, StateVector b) => new(a.Position + b.Position, a.Velocity + b.Velocity);

    /// <summary>The state relative to that of another body.</summary>
    public static StateVector operator -(StateVector a, StateVector b) => new(a.Position - b.Position, a.Velocity - b.Velocity);

    /// <summary>Changes the unit of length.</summary>
    public static StateVector operator *(double factor, StateVector a) => new(factor * a.Position, factor * a.Velocity);

    /// <summary>Turns both along the axes of a frame that does not turn itself.</summary>
    public static StateVector operator *(RotationMatrix rotation, StateVector a) => new(rotation * a.Position, rotation * a.Velocity);
}

/// <summary>How the frames of spacecraft and instruments are turned. Safe for several threads.</summary>
public interface ISpaceFrames
{
    /// <summary>The rotation that turns J2000 components into those of a frame.</summary>
    /// <param name="frame">Name of the frame, e.g. "LRO_LROCNACL".</param>
    /// <exception cref="MsisfException">The frame is not known, or not at that time.</exception>
    RotationMatrix FrameFromJ2000(string frame, TdbTime time);
}
