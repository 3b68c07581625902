using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>The data of one body for one stretch of time, from one kernel. Safe for several threads.</summary>
public interface IEphemerisSegment
{
    /// <summary>NAIF's number of the body, or of the body-fixed frame's class for an orientation.</summary>
    int Body { get; }

    /// <summary>NAIF's number of the body that a position is relative to; 0 for an orientation.</summary>
    int Center { get; }

    /// <summary>Times for which the data are valid.</summary>
    TdbInterval Interval { get; }

    /// <summary>
    /// The position relative to <see cref="Center"/> in km, J2000; or the three angles in rad that turn J2000 into the body-fixed frame
    /// (axes 3, 1, 3).
    /// </summary>
    /// <param name="time">Inside <see cref="Interval"/>.</param>
    /// <exception cref="SpiceException">The kernel is damaged, or holds the data in a form that can't be read.</exception>
    Vector3D ValueAt(TdbTime time);

    /// <summary>Rate of change of <see cref="ValueAt"/>: km/s, or rad/s.</summary>
    /// <param name="time">Inside <see cref="Interval"/>.</param>
    /// <exception cref="SpiceException">The kernel is damaged, or holds the data in a form that can't be read.</exception>
    Vector3D RateAt(TdbTime time);

    /// <summary>Both at once, as a state in km and km/s.</summary>
    /// <inheritdoc cref="ValueAt"/>
    StateVector StateAt(TdbTime time) => new(ValueAt(time), RateAt(time));
}
